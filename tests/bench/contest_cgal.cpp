#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "bench/contest.h"

namespace rbpa_bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using PlainDelaunay = CGAL::Delaunay_triangulation_2<Kernel>;

using IndexedVertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using IndexedStorage = CGAL::Triangulation_data_structure_2<IndexedVertex, CGAL::Triangulation_face_base_2<Kernel>>;
using IndexedDelaunay = CGAL::Delaunay_triangulation_2<Kernel, IndexedStorage>;
using IndexedPoint = std::pair<Point, std::uint32_t>;
using SortTraits = CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::First_of_pair_property_map<IndexedPoint>>;

using AlphaStorage = CGAL::Triangulation_data_structure_2<CGAL::Alpha_shape_vertex_base_2<Kernel>,
                                                          CGAL::Alpha_shape_face_base_2<Kernel>>;
using AlphaShape = CGAL::Alpha_shape_2<CGAL::Delaunay_triangulation_2<Kernel, AlphaStorage>>;

/// Filter of triangles by circumradius, in plain double arithmetic.
enum class Filter { none, circumradius };

bool circumradius_at_most(const Point& a, const Point& b, const Point& c, double alpha) {
  const double ux = b.x() - a.x(), uy = b.y() - a.y(), vx = c.x() - a.x(), vy = c.y() - a.y();
  const double wx = vx - ux, wy = vy - uy, cross = ux * vy - uy * vx;
  return (ux * ux + uy * uy) * (vx * vx + vy * vy) * (wx * wx + wy * wy) <= 4 * alpha * alpha * cross * cross;
}

template <typename Face>
bool passes(const Face& face, double alpha, Filter filter) {
  return filter == Filter::none ||
         circumradius_at_most(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point(), alpha);
}

std::vector<Point> as_points(std::span<const rbpa::Point> points) {
  std::vector<Point> all;
  all.reserve(points.size());
  for (const rbpa::Point& p : points) all.emplace_back(p.x, p.y);
  return all;
}

Run run_indices(std::span<const rbpa::Point> points, double alpha, Filter filter, Triangles* list) {
  const Stopwatch watch;
  std::vector<IndexedPoint> indexed;
  indexed.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) indexed.push_back({Point(points[i].x, points[i].y), i});
  // Sorting pairs in place and inserting them one after the other is a quarter faster than insert(first, last), which
  // sorts indices; CGAL's other policy of the Hilbert curve is slower than this one on grids.
  CGAL::spatial_sort(indexed.begin(), indexed.end(), SortTraits());
  IndexedDelaunay triangulation;
  IndexedDelaunay::Face_handle near = nullptr;
  for (const auto& [point, index] : indexed) {
    const IndexedDelaunay::Vertex_handle vertex = triangulation.insert(point, near);
    vertex->info() = index;
    near = vertex->face();
  }

  Triangles triangles;
  triangles.reserve(triangulation.number_of_faces());
  for (const auto face : triangulation.finite_face_handles())
    if (passes(face, alpha, filter))
      triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  const Run run = watch.run(triangles.size());
  if (list) *list = std::move(triangles);
  return run;
}

Run run_points(std::span<const rbpa::Point> points, double alpha, Filter filter) {
  const std::vector<Point> own = as_points(points);
  const Stopwatch watch;
  const PlainDelaunay triangulation(own.begin(), own.end());
  if (filter == Filter::none) return watch.run(triangulation.number_of_faces());
  std::vector<PlainDelaunay::Face_handle> faces;
  faces.reserve(triangulation.number_of_faces());
  for (const auto face : triangulation.finite_face_handles())
    if (passes(face, alpha, filter)) faces.push_back(face);
  return watch.run(faces.size());
}

Run run_alpha_shape(std::span<const rbpa::Point> points, double alpha) {
  const std::vector<Point> own = as_points(points);
  const Stopwatch watch;
  const AlphaShape shape(own.begin(), own.end(), alpha * alpha, AlphaShape::GENERAL);
  std::size_t interior = 0;
  for (const auto face : shape.finite_face_handles())
    if (shape.classify(face) == AlphaShape::INTERIOR) ++interior;
  return watch.run(interior);
}

Method indices(const char* name, Filter filter) {
  return {name,
          [filter](auto points, double alpha, Triangles* list) { return run_indices(points, alpha, filter, list); },
          filter != Filter::none};
}

Method points_alone(const char* name, Filter filter) {
  return {name, [filter](auto points, double alpha, Triangles*) { return run_points(points, alpha, filter); },
          filter != Filter::none};
}

}  // namespace

Method cgal_indices() { return indices("CGAL indices", Filter::none); }
Method cgal_indices_filtered() { return indices("CGAL indices + filter", Filter::circumradius); }
Method cgal_points() { return points_alone("CGAL points", Filter::none); }
Method cgal_points_filtered() { return points_alone("CGAL points + filter", Filter::circumradius); }
Method cgal_alpha_shape() {
  return {"CGAL Alpha_shape_2", [](auto points, double alpha, Triangles*) { return run_alpha_shape(points, alpha); }};
}

}  // namespace rbpa_bench

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

#include "bench/contest.h"

namespace rbpa_bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Storage = CGAL::Triangulation_data_structure_2<VertexBase, CGAL::Triangulation_face_base_2<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, Storage>;
using IndexedPoint = std::pair<Kernel::Point_2, std::uint32_t>;
using SortTraits = CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::First_of_pair_property_map<IndexedPoint>>;

bool circumradius_at_most(const Kernel::Point_2& a, const Kernel::Point_2& b, const Kernel::Point_2& c, double alpha) {
  const double ux = b.x() - a.x(), uy = b.y() - a.y(), vx = c.x() - a.x(), vy = c.y() - a.y();
  const double wx = vx - ux, wy = vy - uy, cross = ux * vy - uy * vx;
  return (ux * ux + uy * uy) * (vx * vx + vy * vy) * (wx * wx + wy * wy) <= 4 * alpha * alpha * cross * cross;
}

}  // namespace

Run run_cgal(std::span<const rbpa::Point> points, double alpha) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<IndexedPoint> indexed;
  indexed.reserve(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) indexed.push_back({Kernel::Point_2(points[i].x, points[i].y), i});
  // Pairs sorted in place and inserted one after the other are a quarter faster than insert(first, last), which sorts
  // indices; CGAL's other policy of the Hilbert curve is slower than this one on grids.
  CGAL::spatial_sort(indexed.begin(), indexed.end(), SortTraits());
  Delaunay triangulation;
  Delaunay::Face_handle near = nullptr;
  for (const auto& [point, index] : indexed) {
    const Delaunay::Vertex_handle vertex = triangulation.insert(point, near);
    vertex->info() = index;
    near = vertex->face();
  }

  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(triangulation.number_of_faces());
  for (const auto face : triangulation.finite_face_handles()) {
    const auto a = face->vertex(0), b = face->vertex(1), c = face->vertex(2);
    if (circumradius_at_most(a->point(), b->point(), c->point(), alpha))
      triangles.push_back({a->info(), b->info(), c->info()});
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return {seconds.count(), triangles.size()};
}

}  // namespace rbpa_bench

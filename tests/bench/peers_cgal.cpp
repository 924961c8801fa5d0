#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "bench/peers.h"

namespace rbpa_bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_2<Kernel>,
                                                 CGAL::Delaunay_mesh_face_base_2<Kernel>>>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Constrained>;

std::vector<Kernel::Point_2> places_of(std::span<const rbpa::Point> points) {
  std::vector<Kernel::Point_2> places;
  places.reserve(points.size());
  for (const rbpa::Point& p : points) places.emplace_back(p.x, p.y);
  return places;
}

Constrained constrained(const std::vector<rbpa::Point>& ring) {
  const std::vector<Kernel::Point_2> places = places_of(ring);
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t i = 0; i < ring.size(); ++i) edges.emplace_back(i, (i + 1) % ring.size());
  Constrained result;
  result.insert_constraints(places.begin(), places.end(), edges.begin(), edges.end());
  return result;
}

}  // namespace

Run fill_by_cgal(const std::vector<rbpa::Point>& ring, double longest) {
  const Stopwatch watch;
  Constrained mesh = constrained(ring);
  constexpr double usual_shape = 0.125;  // the squared sine of 20.7°
  CGAL::Delaunay_mesher_2<Constrained, Criteria> mesher(mesh, Criteria(usual_shape, longest));
  mesher.refine_mesh();
  Run run = watch.run(0);
  for (const auto face : mesh.finite_face_handles()) run.count += face->is_in_domain() ? 1U : 0U;
  return run;
}

Run constrained_by_cgal(std::span<const rbpa::Point> points, std::span<const rbpa::Segment> segments) {
  const std::vector<Kernel::Point_2> places = places_of(points);
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& [a, b] : segments) edges.emplace_back(a, b);
  const Stopwatch watch;
  CGAL::Constrained_Delaunay_triangulation_2<Kernel> made;
  made.insert_constraints(places.begin(), places.end(), edges.begin(), edges.end());
  return watch.run(made.number_of_faces());
}

Run voronoi_by_cgal(std::span<const rbpa::Point> points) {
  using Faces = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, Kernel>;
  using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
  using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>>;
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> places;
  places.reserve(points.size());
  for (const rbpa::Point& p : points)
    places.emplace_back(Kernel::Point_2(p.x, p.y), static_cast<std::uint32_t>(places.size()));
  const Stopwatch watch;
  const Delaunay delaunay(places.begin(), places.end());
  std::vector<Kernel::Point_2> centers;
  centers.reserve(delaunay.number_of_faces());
  for (const auto face : delaunay.all_face_handles()) {
    face->info() = std::numeric_limits<std::uint32_t>::max();
    if (delaunay.is_infinite(face)) continue;
    face->info() = static_cast<std::uint32_t>(centers.size());
    centers.push_back(delaunay.circumcenter(face));
  }
  std::vector<std::array<std::uint32_t, 4>> ridges;
  ridges.reserve(3 * points.size());
  for (const auto& [face, i] : delaunay.finite_edges())
    ridges.push_back({face->vertex(Delaunay::ccw(i))->info(), face->vertex(Delaunay::cw(i))->info(), face->info(),
                      face->neighbor(i)->info()});
  std::vector<std::uint32_t> of_regions, point_region(points.size());
  std::vector<std::size_t> begin = {0};
  of_regions.reserve(6 * points.size());
  begin.reserve(points.size() + 1);
  for (const auto vertex : delaunay.finite_vertex_handles()) {
    const auto first = vertex->face();
    auto face = first;
    do {
      of_regions.push_back(face->info());
      face = face->neighbor(Delaunay::ccw(face->index(vertex)));
    } while (face != first);
    point_region[vertex->info()] = static_cast<std::uint32_t>(begin.size() - 1);
    begin.push_back(of_regions.size());
  }
  return watch.run(centers.size());
}

Run solid_by_cgal(std::span<const rbpa::Point3> points, double alpha) {
  std::vector<Kernel::Point_3> own;
  own.reserve(points.size());
  for (const rbpa::Point3& p : points) own.emplace_back(p.x, p.y, p.z);
  const Stopwatch watch;
  const CGAL::Delaunay_triangulation_3<Kernel> delaunay(own.begin(), own.end());
  std::size_t count = 0;
  if (std::isinf(alpha)) {
    count = delaunay.number_of_finite_cells();
  } else if (delaunay.dimension() == 3) {
    for (auto c = delaunay.finite_cells_begin(); c != delaunay.finite_cells_end(); ++c)
      count += CGAL::squared_radius(c->vertex(0)->point(), c->vertex(1)->point(), c->vertex(2)->point(),
                                    c->vertex(3)->point()) <= alpha * alpha;
  }
  return watch.run(count);
}

}  // namespace rbpa_bench

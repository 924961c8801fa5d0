// Compares fill() without a size with CGAL's constrained Delaunay triangulation.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "rbpa/fill.h"
#include "rbpa/plane/predicate/predicates.h"
#include "support/generate_polygons.h"

namespace rbpa_test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Peer = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertices, CGAL::Constrained_triangulation_face_base_2<Kernel>>>;
using Triangle = std::array<std::uint32_t, 3>;

std::set<Triangle> peer_triangles(const PolygonCase& polygon) {
  Peer peer;
  std::vector<Peer::Vertex_handle> handle;
  for (std::uint32_t i = 0; i < polygon.points.size(); ++i) {
    handle.push_back(peer.insert({polygon.points[i].x, polygon.points[i].y}));
    handle.back()->info() = i;
  }
  const auto constrain = [&](const rbpa::Ring& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i)
      peer.insert_constraint(handle[ring.points[i]], handle[ring.points[(i + 1) % ring.points.size()]]);
  };
  for (const rbpa::Polygon& one : polygon.polygons) {
    constrain(one.shell);
    for (const rbpa::Ring& hole : one.holes) constrain(hole);
  }
  std::set<Triangle> triangles;
  for (const auto face : peer.finite_face_handles()) {
    Triangle t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.insert(t);
  }
  return triangles;
}

/// Returns whether the four corners of any two neighboring triangles lie on one circle. If so, the constrained Delaunay
/// triangulation is not unique.
bool has_ties(const rbpa::Filling& filling) {
  for (std::size_t t = 0; t < filling.triangles.size(); ++t)
    for (const std::uint32_t other : filling.neighbors[t]) {
      if (other == rbpa::TriangleArrays::none || other < t) continue;
      const auto& [a, b, c] = filling.triangles[t];
      for (const std::uint32_t q : filling.triangles[other])
        if (q != a && q != b && q != c &&
            rbpa::Predicates<long double>::in_circle(filling.points[a], filling.points[b], filling.points[c],
                                                     filling.points[q]) == 0)
          return true;
    }
  return false;
}

}  // namespace

TEST_CASE("without ties the triangles inside are those of CGAL's constrained Delaunay triangulation") {
  std::size_t compared = 0;
  for (std::size_t number = 0; number < 400; ++number) {
    const PolygonCase polygon = polygon_case(number);
    INFO(polygon.name);
    const rbpa::Filling filling =
        rbpa::fill(polygon.points, polygon.polygons, {.size = std::numeric_limits<double>::infinity()});
    if (has_ties(filling)) continue;
    ++compared;
    // Both triangulate the same set, so that it is enough to find each of our triangles in CGAL's.
    const std::set<Triangle> peer = peer_triangles(polygon);
    std::size_t missing = 0;
    for (const Triangle& triangle : filling.triangles) missing += peer.count(triangle) == 0;
    CHECK(missing == 0);
  }
  CHECK(compared > 100);
}

}  // namespace rbpa_test

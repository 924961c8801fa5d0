// Compares constrained_delaunay(), and fill() without a size, with CGAL's constrained Delaunay triangulation.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <span>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/fill.h"
#include "rbpa/plane/constrained_delaunay.h"
#include "rbpa/plane/predicate/predicates.h"
#include "support/generate_polygons.h"
#include "support/random.h"

namespace rbpa_test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Peer = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertices, CGAL::Constrained_triangulation_face_base_2<Kernel>>>;
using Triangle = std::array<std::uint32_t, 3>;

/// Returns CGAL's triangles. Requires: distinct points, and segments that do not cross.
std::set<Triangle> peer_triangles(std::span<const rbpa::Point> points, std::span<const rbpa::Segment> segments) {
  Peer peer;
  std::vector<Peer::Vertex_handle> handle;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    handle.push_back(peer.insert({points[i].x, points[i].y}));
    handle.back()->info() = i;
  }
  for (const auto& [a, b] : segments) peer.insert_constraint(handle[a], handle[b]);
  std::set<Triangle> triangles;
  for (const auto face : peer.finite_face_handles()) {
    Triangle t{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.insert(t);
  }
  return triangles;
}

std::vector<rbpa::Segment> sides_of(const std::vector<rbpa::Polygon>& polygons) {
  std::vector<rbpa::Segment> sides;
  const auto add = [&](const rbpa::Ring& ring) {
    for (std::size_t i = 0; i < ring.points.size(); ++i)
      sides.push_back({ring.points[i], ring.points[(i + 1) % ring.points.size()]});
  };
  for (const rbpa::Polygon& one : polygons) {
    add(one.shell);
    for (const rbpa::Ring& hole : one.holes) add(hole);
  }
  return sides;
}

/// Returns whether the four corners of any two neighboring triangles lie on one circle. If so, the constrained Delaunay
/// triangulation is not unique.
bool has_ties(std::span<const rbpa::Point> points, const rbpa::TriangleArrays& of) {
  for (std::size_t t = 0; t < of.triangles.size(); ++t)
    for (const std::uint32_t other : of.neighbors[t]) {
      if (other == rbpa::TriangleArrays::none || other < t) continue;
      const auto& [a, b, c] = of.triangles[t];
      for (const std::uint32_t q : of.triangles[other])
        if (q != a && q != b && q != c &&
            rbpa::Predicates<long double>::in_circle(points[a], points[b], points[c], points[q]) == 0)
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
    if (has_ties(filling.points, filling)) continue;
    ++compared;
    // Both triangulate the same set, so that it is enough to find each of our triangles in CGAL's.
    const std::set<Triangle> peer = peer_triangles(polygon.points, sides_of(polygon.polygons));
    std::size_t missing = 0;
    for (const Triangle& triangle : filling.triangles) missing += peer.count(triangle) == 0;
    CHECK(missing == 0);
  }
  CHECK(compared > 100);
}

TEST_CASE("without ties the triangles of points and segments are those of CGAL's constrained Delaunay triangulation") {
  Random random(7);
  std::size_t compared = 0, kept = 0;
  for (int i = 0; i < 300; ++i) {
    const int n = random.integer(3, i % 10 == 0 ? 3000 : 100);
    std::vector<rbpa::Point> points;
    for (int k = 0; k < n; ++k) points.push_back({random.unit(), random.unit()});
    std::vector<rbpa::Segment> segments;
    rbpa::ConstrainedDelaunay made = rbpa::constrained_delaunay(points, segments);
    for (int k = 0; k < 60; ++k) {  // of random segments those that cross none before
      segments.push_back({static_cast<std::uint32_t>(random.below(points.size())),
                          static_cast<std::uint32_t>(random.below(points.size()))});
      try {
        made = rbpa::constrained_delaunay(points, segments);
        ++kept;
      } catch (const rbpa::InvalidInput&) {
        segments.pop_back();
      }
    }
    if (has_ties(points, made)) continue;
    ++compared;
    const std::set<Triangle> peer = peer_triangles(points, segments);
    CHECK(std::set<Triangle>(made.triangles.begin(), made.triangles.end()) == peer);
  }
  CHECK(compared > 290);
  CHECK(kept > 1'000);
}

}  // namespace rbpa_test

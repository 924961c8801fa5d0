// Compares dangling_faces() with CGAL's Alpha_shape_3.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "oracle/cgal_dangling.h"
#include "rbpa/space/balls/dangling_faces.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_radii.h"
#include "support/arguments.h"
#include "support/solid_sets.h"
#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Points3 distinct(Points3 points) {
  const auto less = [](const Point3& a, const Point3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// Checks some radii of tetrahedra as floats, whose squares are doubles. Returns: the number of dangling simplices.
std::size_t check(const Points3& points) {
  const rbpa::Solid delaunay = rbpa::solid(points, infinity);
  if (delaunay.simplices.empty()) return 0;
  const std::vector<double> radii = rbpa::circumradii(points, delaunay.simplices);
  std::vector<double> sorted = radii;
  std::sort(sorted.begin(), sorted.end());
  std::size_t count = 0;
  for (const double share : {0.0, 0.05, 0.3, 0.6, 0.95}) {
    const double radius = sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    const double alpha = static_cast<double>(static_cast<float>(share == 0 ? 0.7 * radius : radius));
    if (!(alpha > 1e-30 && alpha < 1e30)) continue;
    CAPTURE(alpha);
    const DanglingByCgal expected = AlphaShapeByCgal(points).dangling(alpha);
    const rbpa::DanglingFaces found = rbpa::dangling_faces(points, delaunay, radii, alpha);
    CHECK(found.triangles == expected.triangles);
    CHECK(found.edges == expected.edges);
    CHECK(found.points == expected.points);
    count += expected.triangles.size() + expected.edges.size() + expected.points.size();
  }
  return count;
}

}  // namespace

TEST_CASE("dangling simplices of small sets of every kind are singular in CGAL's alpha shape") {
  const std::uint64_t sets = argument("count", 200) / space_kinds;
  std::size_t dangling = 0;
  for (int k = 0; k < space_kinds; ++k) {
    Random random(300 + static_cast<std::uint64_t>(k));
    CAPTURE(name(static_cast<SpaceKind>(k)));
    for (std::uint64_t trial = 0; trial < sets; ++trial)
      dangling += check(distinct(space_set(static_cast<SpaceKind>(k), 5 + random.below(24), random)));
  }
  CHECK(dangling > 10 * sets);
}

TEST_CASE("dangling simplices of larger sets of every shape are singular in CGAL's alpha shape") {
  std::size_t dangling = 0;
  for (const SolidSet& set : solid_sets(argument("points", 150))) {
    CAPTURE(set.name);
    dangling += check(distinct(set.points));
  }
  CHECK(dangling > 1000);
}

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "oracle/cgal_tetrahedra.h"
#include "rbpa/space/solid/solid.h"
#include "support/arguments.h"
#include "support/solid_sets.h"
#include "support/space_sets.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::Solid;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool same(const Solid& actual, const TetrahedraByCgal& expected) {
  return actual.simplices == expected.simplices && actual.neighbors == expected.neighbors;
}

/// Returns a text for people: the points and the radius as doubles that read back.
std::string text(const Points3& points, double alpha) {
  std::ostringstream out;
  out << std::hexfloat << "alpha " << alpha << ", points";
  for (const Point3& p : points) out << " {" << p.x << ", " << p.y << ", " << p.z << "}";
  return out.str();
}

double circumradius(const Points3& points, const Tetrahedron& t) {
  const auto edge = [&](std::size_t k) { return points[t[k]] - points[t[0]]; };
  const Point3 u = edge(1), v = edge(2), w = edge(3), uv = cross(u, v),
               sum = dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * uv;
  return std::hypot(sum.x, sum.y, sum.z) / (2 * std::abs(dot(uv, w)));
}

/// Returns infinity, circumradii from the least to the greatest, rounded, so that some are just above and some just
/// below, and one radius below all of them.
std::vector<double> alphas(const Points3& points, const std::vector<Tetrahedron>& tetrahedra) {
  std::vector<double> radii;
  for (const Tetrahedron& t : tetrahedra)
    if (const double radius = circumradius(points, t); radius > 0 && std::isfinite(radius)) radii.push_back(radius);
  if (radii.empty()) return {infinity, 1};
  std::sort(radii.begin(), radii.end());
  std::vector<double> chosen = {infinity};
  for (const double share : {0.02, 0.2, 0.5, 0.8, 0.98, 1.0})
    chosen.push_back(radii[static_cast<std::size_t>(share * static_cast<double>(radii.size() - 1))]);
  chosen.push_back(radii.front() / 2);
  return chosen;
}

/// Checks eight alphas. Returns: the total number of tetrahedra.
std::size_t check(const Points3& points) {
  const DelaunayByCgal delaunay(points);
  std::size_t count = 0;
  for (const double alpha : alphas(points, delaunay.within(infinity).simplices)) {
    CAPTURE(alpha);
    const TetrahedraByCgal expected = delaunay.within(alpha);
    const Solid actual = rbpa::solid(points, alpha);
    CHECK(actual.simplices.size() == expected.simplices.size());
    CHECK(same(actual, expected));
    count += expected.simplices.size();
  }
  return count;
}

}  // namespace

TEST_CASE("small sets of every kind have CGAL's Delaunay tetrahedra within alpha, and their neighbors") {
  const std::uint64_t sets = argument("count", 2000) / space_kinds;
  std::size_t tetrahedra = 0;
  for (int k = 0; k < space_kinds; ++k) {
    Random random(200 + static_cast<std::uint64_t>(k));
    CAPTURE(name(static_cast<SpaceKind>(k)));
    for (std::uint64_t trial = 0; trial < sets; ++trial) {
      const Points3 points = space_set(static_cast<SpaceKind>(k), 1 + random.below(24), random);
      const DelaunayByCgal delaunay(points);
      for (const double alpha : {infinity, space_radius(points, random)}) {
        const TetrahedraByCgal expected = delaunay.within(alpha);
        if (!same(rbpa::solid(points, alpha), expected)) FAIL_CHECK(text(points, alpha));
        tetrahedra += expected.simplices.size();
      }
    }
  }
  CHECK(tetrahedra > 100 * sets);
}

TEST_CASE("lattices with moved points have CGAL's Delaunay tetrahedra") {
  const std::uint64_t sets = argument("count", 2000) / 10;
  Random random(203);
  std::size_t tetrahedra = 0;
  for (std::uint64_t trial = 0; trial < sets; ++trial) {
    const Points3 points = moved_lattice(4 + random.below(trial % 8 == 0 ? 400 : 60), random);
    const TetrahedraByCgal expected = DelaunayByCgal(points).within(infinity);
    if (!same(rbpa::solid(points, infinity), expected)) FAIL_CHECK(text(points, infinity));
    tetrahedra += expected.simplices.size();
  }
  CHECK(tetrahedra > 40 * sets);
}

TEST_CASE("many points that fill a volume, computed tile by tile, have CGAL's Delaunay tetrahedra within alpha") {
  const std::size_t count = argument("tiles", 24'000);
  for (const Points3& points : {uniform_cube(count, 204), jittered_cubes(count, 205)})
    CHECK(check(points) > 10 * count);
}

TEST_CASE("larger sets of every shape have CGAL's Delaunay tetrahedra within alpha, for eight alphas") {
  const std::size_t count = argument("points", 300);
  for (const SolidSet& set : solid_sets(count)) {
    CAPTURE(set.name);
    const std::size_t found = check(set.points);
    CHECK((found > 100) == set.is_solid);
  }
}

TEST_CASE("parts of a grid of 4 by 4 by 4 have CGAL's Delaunay tetrahedra") {
  const std::uint64_t sets = argument("count", 2000) / 20;
  Random random(201);
  std::size_t tetrahedra = 0;
  for (std::uint64_t trial = 0; trial < sets; ++trial) {
    Points3 points;
    for (int i = 0; i < 64; ++i)
      if (random.chance(trial % 4 == 0 ? 1 : 0.6))
        points.push_back({double(i & 3), double(i >> 2 & 3), double(i >> 4)});
    random.shuffle(points);
    const TetrahedraByCgal expected = DelaunayByCgal(points).within(infinity);
    if (!same(rbpa::solid(points, infinity), expected)) FAIL_CHECK(text(points, infinity));
    tetrahedra += expected.simplices.size();
  }
  CHECK(tetrahedra > 40 * sets);
}

TEST_CASE("the oracle detects wrong results") {
  Random random(202);
  const Points3 points = space_set(SpaceKind::cube, 50, random);
  const DelaunayByCgal delaunay(points);
  const Solid right = rbpa::solid(points, infinity);
  REQUIRE(same(right, delaunay.within(infinity)));
  Solid wrong = right;
  std::swap(wrong.neighbors[0][0], wrong.neighbors[0][1]);
  CHECK(!same(wrong, delaunay.within(infinity)));
  wrong = right;
  std::swap(wrong.simplices[0][2], wrong.simplices[0][3]);
  CHECK(!same(wrong, delaunay.within(infinity)));
  CHECK(!same(right, delaunay.within(0.5)));
  CHECK(!delaunay.within(0.5).simplices.empty());
}

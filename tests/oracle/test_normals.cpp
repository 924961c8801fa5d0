#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "oracle/cgal_normals.h"
#include "rbpa/space/normals/estimate_normals.h"
#include "support/space_sets.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::Point3;

namespace {

/// Returns the share of our normals that differ from CGAL's by a degree or more.
double others(const Points3& points, std::size_t neighbors, std::size_t of_cgal) {
  const Points3 ours = rbpa::estimate_normals(points, {.neighbors = neighbors});
  const Points3 theirs = normals_by_cgal(points, of_cgal);
  REQUIRE(ours.size() == theirs.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) count += length(cross(ours[i], theirs[i])) > 0.0175;
  return static_cast<double>(count) / static_cast<double>(ours.size());
}

Points3 distinct(SpaceKind kind, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  const Points3 any = space_set(kind, count, random);
  const std::set<Point3> once(any.begin(), any.end());
  return {once.begin(), once.end()};
}

}  // namespace

// The sets have no equal distances and no two directions that fit equally well. CGAL's own iteration ends when it is
// near; tests/rbpa/space/surface/neighbors/fit_plane.cpp is exact.
TEST_CASE("the fitted planes are those of CGAL") {
  for (const std::size_t neighbors : {6u, 16u, 40u}) {
    CAPTURE(neighbors);
    CHECK(others(distinct(SpaceKind::near_sphere, 2000, 31), neighbors, neighbors) < 0.005);
    CHECK(others(distinct(SpaceKind::noisy_sphere, 2000, 32), neighbors, neighbors) < 0.005);
    CHECK(others(distinct(SpaceKind::plate, 2000, 33), neighbors, neighbors) < 0.005);
    CHECK(others(distinct(SpaceKind::cube, 12, 34), neighbors, neighbors) < 0.005);
  }
}

TEST_CASE("the comparison detects another number of neighbors") {
  const Points3 points = distinct(SpaceKind::noisy_sphere, 500, 35);
  CHECK(others(points, 15, 16) > 0.2);
}

#include "rbpa/space/surface/neighbors/fit_plane.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "support/space_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::space::Neighborhoods;

TEST_SUITE_BEGIN("space");

namespace {

using Vector = std::array<long double, 3>;

long double dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

/// Returns point i and the points around it, relative to their centroid.
std::vector<Vector> centered(const Neighborhoods& points, std::size_t i) {
  std::vector<Vector> all = {{points.points[i].x, points.points[i].y, points.points[i].z}};
  for (const std::uint32_t j : points.around(i))
    all.push_back({points.points[j].x, points.points[j].y, points.points[j].z});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    long double sum = 0;
    for (const Vector& v : all) sum += v[axis];
    for (Vector& v : all) v[axis] -= sum / static_cast<long double>(all.size());
  }
  return all;
}

/// Returns the sum of squared distances to the plane through the centroid.
long double misfit(const std::vector<Vector>& points, const Vector& normal) {
  long double sum = 0;
  for (const Vector& v : points) sum += dot(v, normal) * dot(v, normal);
  return sum / dot(normal, normal);
}

}  // namespace

TEST_CASE("no other plane fits better, in any direction and to first order") {
  Random random(41);
  for (int k = 0; k < space_kinds; ++k) {
    if (static_cast<SpaceKind>(k) == SpaceKind::extreme) continue;
    CAPTURE(name(static_cast<SpaceKind>(k)));
    const Points3 any = space_set(static_cast<SpaceKind>(k), 40, random);
    const std::set<Point3> distinct(any.begin(), any.end());
    rbpa::Threads threads(1);
    const Neighborhoods near =
        rbpa::space::find_nearest<double>({distinct.begin(), distinct.end()}, 2 + random.below(16), threads, {});
    for (std::size_t i = 0; i < near.points.size(); ++i) {
      const Point3 found = rbpa::space::fit_plane<double>(near, i).normal;
      const Vector n = {found.x, found.y, found.z};
      CHECK(std::abs(dot(n, n) - 1) < 1e-14L);
      const std::vector<Vector> points = centered(near, i);
      long double size = 0;
      for (const Vector& v : points) size += dot(v, v);
      const long double least = misfit(points, n);
      for (const Point3& d : random_normals(20, random))
        CHECK(least <= misfit(points, {d.x, d.y, d.z}) + 1e-13L * size);
      Vector gradient = {};
      for (const Vector& v : points)
        for (std::size_t axis = 0; axis < 3; ++axis) gradient[axis] += dot(v, n) * v[axis];
      for (std::size_t axis = 0; axis < 3; ++axis) gradient[axis] -= least * n[axis];
      CHECK(std::sqrt(dot(gradient, gradient)) < 1e-12L * size);
    }
  }
}

TEST_SUITE_END();

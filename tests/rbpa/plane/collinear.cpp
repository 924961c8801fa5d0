#include "rbpa/plane/collinear.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "rbpa/rbpa.h"

using rbpa::are_collinear;
using Points = std::vector<rbpa::Point>;

TEST_SUITE_BEGIN("rbpa");

TEST_CASE("points on a line are distinguished from points a last bit off it") {
  const double next = std::nextafter(1.0, 2.0);
  CHECK(are_collinear(Points{{0, 0}, {1, 1}, {3, 3}, {-2, -2}}));
  CHECK(are_collinear(Points{{1e300, 0}, {-1e300, 0}, {1e-300, -0.0}}));
  CHECK(are_collinear(Points{{next, next}, {0, 0}, {5, 5}}));
  CHECK_FALSE(are_collinear(Points{{0, 0}, {5, 5}, {1, next}}));
  CHECK_FALSE(are_collinear(Points{{1e300, 0}, {-1e300, 0}, {0, 5e-324}}));
}

TEST_CASE("a test of many points on a line can be cancelled") {
  Points points;
  for (int i = 0; i < 100000; ++i) points.push_back({double(i), 3.0 * i});
  std::size_t calls = 0;
  CHECK(are_collinear(points, [&] { return ++calls > 0; }));
  CHECK(calls >= 5);
  CHECK_THROWS_AS(are_collinear(points, [] { return false; }), rbpa::Cancelled);
}

TEST_CASE("fewer than three distinct points are on a line") {
  CHECK(are_collinear(Points{}));
  CHECK(are_collinear(Points{{1, 2}}));
  CHECK(are_collinear(Points{{1, 2}, {1, 2}, {1, 2}}));
  CHECK(are_collinear(Points{{0.0, 0}, {-0.0, 0}, {7, 9}, {7, 9}}));
}

TEST_CASE("three points are on a line if and only if they have no Delaunay triangle") {
  for (int code = 0; code < 729; ++code) {
    Points points;
    for (int rest = code, i = 0; i < 3; ++i, rest /= 9) points.push_back({double(rest % 3), double(rest / 3 % 3)});
    const auto complex = rbpa::rbpa(points, std::numeric_limits<double>::infinity());
    CHECK(are_collinear(points) == (complex.mesh.n_faces() == 0));
  }
}

TEST_SUITE_END();

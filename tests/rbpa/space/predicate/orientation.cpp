#include "rbpa/space/predicate/orientation.h"

#include <doctest/doctest.h>

#include <cmath>

using rbpa::Point3;
using rbpa::space::orientation;
using rbpa::space::orientation_along;

TEST_SUITE_BEGIN("space");

TEST_CASE("sides of lines and planes are exact, also at the limits of double") {
  for (const double size : {1.0, 1e-320, 1e-160, 1e307}) {
    CAPTURE(size);
    const Point3 o = {0, 0, 0}, y = {0, size, 0}, z = {0, 0, size}, x = {size, 0, 0};
    CHECK(orientation_along(o, y, z, 0) == 1);
    CHECK(orientation_along(o, z, y, 0) == -1);
    CHECK(orientation_along(y, z, {5, size / 2, size / 2}, 0) == 0);
    CHECK(orientation(o, y, z, x) == 1);
    CHECK(orientation(o, z, y, x) == -1);
    CHECK(orientation(o, y, z, {0, size, size}) == 0);
    CHECK(orientation(o, y, z, {5e-324, size, size}) == 1);
    CHECK(orientation(x, y, z, {size, std::nextafter(0.0, -1), 0}) == -1);
  }
}

TEST_SUITE_END();

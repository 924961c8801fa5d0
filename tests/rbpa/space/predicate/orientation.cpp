#include "rbpa/space/predicate/orientation.h"

#include <doctest/doctest.h>

#include <cmath>

#include "rbpa/space/predicate/exact.h"

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

TEST_CASE("distances are compared exactly, also where their squares round to the same number") {
  for (const double size : {1.0, 1e-300, 1e300}) {
    CAPTURE(size);
    const Point3 o = {0, 0, 0}, far = {size, size * 0x1p-60, 0}, near = {0, 0, size};
    CHECK(rbpa::space::exact::compare_distances(o, far, near) == 1);
    CHECK(rbpa::space::exact::compare_distances(o, near, far) == -1);
    CHECK(rbpa::space::exact::compare_distances(o, near, {-size, 0, 0}) == 0);
  }
}

TEST_SUITE_END();

#include "rbpa/space/solid/periodic/torus.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "oracle/rational.h"
#include "rbpa/base/error.h"
#include "support/random.h"

TEST_SUITE_BEGIN("space");

using rbpa::Point3;
using rbpa::space::Torus;
using namespace rbpa_test;

TEST_CASE("every image of a wrapped point is exact, and rounding moves it by a tiny part of a side") {
  Random random(71);
  for (int trial = 0; trial < 20'000; ++trial) {
    const double side = std::ldexp(0.5 + random.unit() / 2, random.integer(-899, 899));
    const Torus torus({side, 2 * side > 0x1p900 ? side : 2 * side, side});
    const double box = torus.box().x;
    CHECK(std::abs(box - side) <= side * 0x1p-51);
    double x = side * random.between(-3, 3);
    if (trial % 4 == 0) x = std::ldexp(x, random.integer(-60, 60));
    if (trial % 16 == 1) x = random.integer(-3, 3) * side;
    if (trial % 16 == 2) x = std::nextafter(random.integer(-3, 3) * side, side * random.between(-4, 4));
    const Point3 p = torus.wrapped({x, x, -x});
    CHECK(p.x >= 0);
    CHECK(p.x < box);
    CHECK(!std::signbit(p.x));
    // The difference is a multiple of the side, plus little.
    const double remainder = std::abs(std::remainder(std::remainder(x, side) - p.x, side));
    CHECK(remainder <= side * 0x1p-50);
    for (const int offset : {-1, 0, 1}) {
      const Point3 image = torus.image(p, {static_cast<std::int8_t>(offset), 0, 1});
      CHECK(rational(image.x) == rational(p.x) + offset * rational(box));
      CHECK(rational(image.z) == rational(p.z) + rational(box));
      CHECK(rational(box - p.x) == rational(box) - rational(p.x));
    }
  }
}

TEST_CASE("multiples of a small part of the box are not rounded") {
  const Torus torus({10, 12.5, 7});
  CHECK(torus.box() == Point3{10, 12.5, 7});
  CHECK(torus.wrapped({3.25, 12.5, -1}) == Point3{3.25, 0, 6});
  CHECK(torus.wrapped({-10, -0.0, 700000003}) == Point3{0, 0, 3});
  CHECK(torus.most_radius() < 3.5);
  CHECK(torus.most_radius() > 3.4999999999999);
}

TEST_CASE("a box without three valid sides is refused") {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const double bad : {0.0, -1.0, infinity, nan, 0x1p-901, 0x1.8p900}) {
    CAPTURE(bad);
    for (const Point3& box : {Point3{bad, 1, 1}, Point3{1, bad, 1}, Point3{1, 1, bad}}) {
      try {
        const Torus torus(box);
        FAIL_CHECK("not refused");
      } catch (const rbpa::InvalidInput& e) {
        CHECK(std::string(e.what()).find("a side of the box is") == 0);
      }
    }
  }
}

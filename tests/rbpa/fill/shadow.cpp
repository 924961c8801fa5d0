// What edges hide, and what that is good for.
#include "rbpa/fill/shadow.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

#include "fill/laws.h"
#include "rbpa/fill.h"
#include "support/exact.h"
#include "support/random.h"

TEST_SUITE_BEGIN("fill");

using rbpa::Point;
using rbpa::Shadow;
using rbpa_test::Points;
using rbpa_test::exact::orientation;

namespace {

Point on_a_grid(rbpa_test::Random& random) {
  return {double(random.integer(-4, 4)) / 3 + 1e3, double(random.integer(-4, 4)) / 3};
}

/// The way between them meets the segment from p to q, and neither ends on it.
bool is_between(const Point& eye, const Point& p, const Point& q, const Point& at) {
  return orientation(p, q, eye) * orientation(p, q, at) < 0 && orientation(eye, at, p) * orientation(eye, at, q) <= 0;
}

}  // namespace

TEST_CASE("a segment hides another from a point exactly if it is met on the way to both of its ends") {
  rbpa_test::Random random(3);
  int hidden = 0, behind = 0;
  for (int i = 0; i < 20000; ++i) {
    const Point eye = on_a_grid(random), p = on_a_grid(random), q = on_a_grid(random), r = on_a_grid(random),
                s = on_a_grid(random);
    if (orientation(p, q, eye) <= 0) continue;
    const bool is_hidden = Shadow::cast(eye, p, q).hides(r, s);
    REQUIRE(is_hidden == (is_between(eye, p, q, r) && is_between(eye, p, q, s)));
    const bool is_behind = Shadow::behind(p, q).hides(r, s);
    REQUIRE(is_behind == (orientation(p, q, r) < 0 && orientation(p, q, s) < 0));
    hidden += is_hidden;
    behind += is_behind;
  }
  CHECK(hidden > 100);
  CHECK(behind > 100);
}

TEST_CASE("in combs and saws of hundreds of teeth few edges are compared with each triangle, as most are hidden") {
  constexpr int teeth = 500;
  constexpr double width = 1.0 / teeth;
  Points comb = {{0, -1}, {1, -1}, {1, 0}}, saw = comb;
  for (int i = teeth; i > 0; --i) {
    for (const Point& p :
         Points{{(i - 0.5) * width, 0}, {(i - 0.5) * width, 1}, {(i - 1) * width, 1}, {(i - 1) * width, 0}})
      comb.push_back(p);
    saw.push_back({(i - 0.5) * width, 1});
    saw.push_back({(i - 1) * width, 0});
  }
  comb.pop_back();
  const auto compared = [](const Points& points, double size) {
    std::vector<rbpa::Polygon> polygons(1);
    for (std::uint32_t i = 0; i < points.size(); ++i) polygons[0].shell.points.push_back(i);
    const rbpa::Filling filling = rbpa::fill(points, polygons, {.size = size});
    CHECK(rbpa_test::wrong_with_filling(filling, points, polygons, false) == "");
    return filling.compared / filling.triangles.size();
  };
  CHECK(compared(saw, 10) < 4000);     // 43,211 if nothing is hidden
  CHECK(compared(comb, 0.05) < 2200);  // 3343
}

TEST_SUITE_END();

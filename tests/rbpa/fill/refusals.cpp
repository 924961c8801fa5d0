// Runs of fill() that end without a filling: refused input, and cancelled runs.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "fill/refusal.h"
#include "support/generate_polygons.h"

TEST_SUITE_BEGIN("fill");

namespace {

using rbpa::fill;
using rbpa::Filling;
using rbpa::Point;
using rbpa::Polygon;
using rbpa_test::Points;
using rbpa_test::PolygonCase;
using rbpa_test::refusal;
using rbpa_test::square;

}  // namespace

TEST_CASE("an invalid polygon is refused, and the message names the place") {
  Points points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {3, 1}, {2, 3}};
  Polygon with_hole = square();
  with_hole.holes.push_back({{4, 5, 6}});
  CHECK(refusal(points, {with_hole}) == "");
  const auto moved = [&](std::size_t i, const Point& p) {
    Points changed = points;
    changed[i] = p;
    return changed;
  };
  const auto names = [](const std::string& why, std::vector<std::string> parts) {
    return std::all_of(parts.begin(), parts.end(), [&](const std::string& part) {
      if (why.find(part) == std::string::npos) MESSAGE("\"" << why << "\" does not have " << part);
      return why.find(part) != std::string::npos;
    });
  };
  CHECK(names(refusal(moved(5, {5, 1}), {with_hole}),
              {"crosses", "from vertex 0 (1, 1) to vertex 1 (5, 1) of hole 0 of polygon 0", "the shell of polygon 0"}));
  // Valid: a hole that touches the shell on an edge, or at a corner; a repeated vertex.
  CHECK(refusal(moved(5, {4, 1}), {with_hole}) == "");
  CHECK(refusal(moved(5, {4, 0}), {with_hole}) == "");
  CHECK(refusal({{1, 1}, {1, 1}, {2, 1}, {1, 2}}, {square()}) == "");
  // Invalid: a hole that touches the shell twice, so that the inside is in two pieces; along an edge; across the shell
  // at a common vertex.
  Points twice = moved(4, {0, 1});
  twice[5] = {4, 1};
  CHECK(names(refusal(twice, {with_hole}), {"touch at (4, 1)", "in one piece"}));
  twice[5] = {0, 2};
  CHECK(names(refusal(twice, {with_hole}), {"runs along", "hole 0 of polygon 0"}));
  Points across = moved(4, {0, 0});
  across[5] = {5, -1};
  across[6] = {5, -2};
  CHECK(names(refusal(across, {with_hole}), {"hole 0 of polygon 0", "expected it in the shell"}));
  CHECK(names(refusal(points, {{.shell = {{0, 1, 3, 2}}}}), {"crosses", "(4, 0)", "(0, 4)"}));
  CHECK(names(refusal(points, {{.shell = {{0, 1, 2, 1}}}}), {"passes (4, 0) twice"}));
  CHECK(names(refusal(points, {{.shell = {{0, 1}}}}), {"the shell of polygon 0", "found 2 points"}));
  CHECK(names(refusal({{0, 0}, {1, 1}, {2, 2}, {3, 3}}, {square()}),
              {"the shell of polygon 0", "(0, 0)", "all points on one line"}));
  CHECK(names(refusal({{1, 1}, {1, 1}, {1, 1}, {1, 1}}, {square()}), {"all points on one line"}));
  CHECK(names(refusal(points, {{.shell = {{0, 1, 9}}}}), {"vertex 2 of the shell of polygon 0", "point 9"}));
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK(names(refusal(moved(6, {nan, 0}), {with_hole}), {"vertex 2 of hole 0 of polygon 0", "finite"}));
  CHECK(names(refusal(moved(1, {infinity, 0}), {with_hole}), {"vertex 1 of the shell of polygon 0", "finite"}));
  // Invalid: wrong nesting.
  points.insert(points.end(), {{10, 10}, {11, 10}, {10, 11}, {1.9, 1.5}, {2.1, 1.5}, {2, 1.7}});
  Polygon hole_outside = square();
  hole_outside.holes.push_back({{7, 8, 9}});
  CHECK(names(refusal(points, {hole_outside}), {"hole 0 of polygon 0", "(10, 10)", "in no ring"}));
  Polygon hole_in_hole = with_hole;
  hole_in_hole.holes.push_back({{10, 11, 12}});
  CHECK(names(refusal(points, {hole_in_hole}), {"hole 1 of polygon 0", "in hole 0 of polygon 0"}));
  CHECK(names(refusal(points, {square(), {.shell = {{10, 11, 12}}}}),
              {"the shell of polygon 1", "in the shell of polygon 0"}));
  CHECK(refusal(points, {with_hole, {.shell = {{10, 11, 12}}}}) == "");
  Polygon hole_of_other{.shell = {{7, 8, 9}}, .holes = {{{10, 11, 12}}}};
  CHECK(names(refusal(points, {square(), hole_of_other}), {"hole 0 of polygon 1", "in the shell of polygon 0"}));
  // Invalid sizes.
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    if (bad != infinity) CHECK(names(refusal(points, {square()}, {.size = bad}), {"size", "above 0"}));
    CHECK(names(refusal(points, {square()}, {.size = 1, .grade = bad}), {"grade", "above 0"}));
    const std::vector<rbpa::SizeAt> sizes = {{{0, 0}, 1}, {{0, 0}, bad}};
    CHECK(names(refusal(points, {square()}, {.size = 1, .sizes = sizes}), {"size 1 of sizes", "above 0"}));
  }
  CHECK(names(refusal(points, {square()}, {.size = infinity, .grade = 1}), {"size", "no point is added", "a grade"}));
  const std::vector<rbpa::SizeAt> nowhere = {{{nan, 0}, 1}};
  CHECK(names(refusal(points, {square()}, {.size = 1, .sizes = nowhere}), {"size 0 of sizes", "finite"}));
  CHECK(names(refusal(points, {square()}, {.size = 1e-9}), {"1e-09", "triangles"}));
}

TEST_CASE("a run with progress can be cancelled at any time") {
  const PolygonCase polygon = rbpa_test::polygon_case(0);
  std::size_t asked = 0, seen = 0;
  const Filling whole = fill(polygon.points, polygon.polygons, {.size = 0.02, .progress = [&](const rbpa::Progress& p) {
                                                                  ++asked;
                                                                  seen = std::max(seen, p.triangles);
                                                                  return true;
                                                                }});
  REQUIRE(asked > 3);
  CHECK(seen > whole.triangles.size() / 2);
  // The number of calls depends on the clock.
  for (std::size_t last = 1; last <= asked / 2; last += std::max(asked / 10, std::size_t{1})) {
    std::size_t left = last;
    CHECK_THROWS_AS(fill(polygon.points, polygon.polygons,
                         {.size = 0.02, .progress = [&](const rbpa::Progress&) { return --left > 0; }}),
                    rbpa::Cancelled);
  }
}

TEST_SUITE_END();

// The number of triangles that fill() expects.
#include "rbpa/fill/size_estimate.h"

#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "fill/refusal.h"
#include "rbpa/fill/fill.h"
#include "support/generate_polygons.h"

TEST_SUITE_BEGIN("fill");

using rbpa_test::refusal;
using rbpa_test::square;

TEST_CASE("what takes more triangles than can be made is refused before it starts, whatever asks for them") {
  const std::vector<rbpa::Point> unit = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<rbpa::SizeAt> tiny = {{{0.5, 0.5}, 1e-9}};
  CHECK(refusal(unit, {square()}, {.size = 1, .grade = 1e-9, .sizes = tiny}).find("would be made") !=
        std::string::npos);
  CHECK(refusal(unit, {square()}, {.size = 1e-9}).find("would be made") != std::string::npos);
  const std::vector<rbpa::Point> thin = {{0, 0}, {1, 0}, {1, 1e-12}, {0, 1e-12}};
  CHECK(refusal(thin, {square()}, {.size = 1e-9}).find("would be made") != std::string::npos);
  // A boundary that stays whole has no more triangles than points.
  CHECK(refusal(thin, {square()}, {.size = 1e-9, .keep_boundary = true}) == "");
  // The same point asks for few where sizes grow from it.
  CHECK(refusal(unit, {square()}, {.size = 1, .sizes = tiny}) == "");
}

TEST_CASE("the estimate is between a third of the triangles and twice as many, where there is room") {
  for (std::size_t number = 0; number < 100; ++number) {
    const rbpa_test::PolygonCase polygon = rbpa_test::polygon_case(number);
    if (!polygon.is_roomy) continue;
    const std::vector<rbpa::SizeAt> sizes = {{polygon.points[0], polygon.size / 8}};
    for (const bool graded : {false, true}) {
      INFO(polygon.name, graded ? ", graded" : "");
      double estimate = 0;
      int calls = 0;
      rbpa::FillOptions options{.size = polygon.size, .estimated = [&](double triangles) {
                                  estimate = triangles;
                                  ++calls;
                                }};
      if (graded) options.sizes = sizes;
      const auto triangles =
          static_cast<double>(rbpa::fill(polygon.points, polygon.polygons, options).triangles.size());
      CHECK(calls == 1);
      CHECK(estimate >= triangles / 3);
      CHECK(estimate <= 2 * triangles);
    }
  }
}

TEST_CASE("a caller who finds the estimate too large ends the run") {
  const std::vector<rbpa::Point> unit = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK_THROWS_AS(rbpa::fill(unit, std::vector{square()},
                             {.size = 1e-4, .estimated = [](double) { throw std::length_error("too many"); }}),
                  std::length_error);
}

TEST_SUITE_END();

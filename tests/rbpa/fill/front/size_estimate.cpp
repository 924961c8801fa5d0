// The number of triangles that fill() expects.
#include "rbpa/fill/front/size_estimate.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "fill/refusal.h"
#include "rbpa/fill.h"
#include "rbpa/plane/alpha_complex.h"
#include "support/generate_polygons.h"
#include "support/random.h"

TEST_SUITE_BEGIN("fill");

using rbpa_test::refusal;
using rbpa_test::square;

TEST_CASE("input that needs more triangles than possible is refused before the start, whatever the cause") {
  const std::vector<rbpa::Point> unit = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<rbpa::SizeAt> tiny = {{{0.5, 0.5}, 1e-9}};
  CHECK(refusal(unit, {square()}, {.size = 1, .grade = 1e-9, .sizes = tiny}).find("would be made") !=
        std::string::npos);
  CHECK(refusal(unit, {square()}, {.size = 1e-9}).find("would be made") != std::string::npos);
  const std::vector<rbpa::Point> thin = {{0, 0}, {1, 0}, {1, 1e-12}, {0, 1e-12}};
  CHECK(refusal(thin, {square()}, {.size = 1e-9}).find("would be made") != std::string::npos);
  // A boundary that stays whole has no more triangles than points.
  CHECK(refusal(thin, {square()}, {.size = 1e-9, .keep_boundary = true}) == "");
  // The tiny size at one point needs few triangles, as sizes grow from there.
  CHECK(refusal(unit, {square()}, {.size = 1, .sizes = tiny}) == "");
}

TEST_CASE("the estimate is between a third and twice the number of triangles, where there is room") {
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

TEST_CASE(
    "parcels in a sliver, whose edges require sizes 2^42 apart, are estimated at the cost of one, and not too high") {
  rbpa_test::Random random(5);
  std::vector<rbpa::Point> points;
  for (int i = 0; i < 100; ++i)
    points.push_back({double(random.integer(0, 300)) / 3 + 1, 1 + 0x1p-40 * double(random.integer(0, 300)) / 3});
  std::vector<rbpa::SizeAt> sources;
  std::vector<rbpa::OutlinePart> parts;
  std::vector<rbpa::Polygon> polygons;
  std::vector<std::size_t> groups;
  for (const auto& corners : rbpa::alpha_complex(points, std::numeric_limits<double>::infinity()).triangles) {
    rbpa::OutlinePart& part = parts.emplace_back();
    part.outline.rings.push_back({.sites = {0, 1, 2}});
    for (std::size_t k = 0; k < 3; ++k) {
      const rbpa::Point &a = points[corners[k]], &b = points[corners[(k + 1) % 3]];
      part.outline.places.push_back(a);
      sources.push_back({{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}, std::hypot(b.x - a.x, b.y - a.y)});
    }
    groups.push_back(polygons.size());
    polygons.push_back({.shell = {{corners[0], corners[1], corners[2]}}});
  }
  CHECK(parts.size() > 100);
  std::size_t calls = 0;
  const std::function<bool()> count = [&] { return ++calls > 0; };
  const double estimate = rbpa::estimate_triangles(parts, rbpa::SizeField(4, 0.5, sources), false, count);
  CHECK(calls < 3000);  // of 16384 steps each
  const auto triangles =
      static_cast<double>(rbpa::fill(points, polygons, {.size = 4, .grade = 0.5, .groups = groups}).triangles.size());
  CHECK(estimate >= triangles / 3);
  CHECK(estimate <= 2 * triangles);
}

TEST_CASE("a caller who finds the estimate too large ends the run") {
  const std::vector<rbpa::Point> unit = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK_THROWS_AS(rbpa::fill(unit, std::vector{square()},
                             {.size = 1e-4, .estimated = [](double) { throw std::length_error("too many"); }}),
                  std::length_error);
}

TEST_SUITE_END();

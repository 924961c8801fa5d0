// fill() of several groups of polygons: parcels that share edges, features that overlap.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fill/laws.h"
#include "fill/refusal.h"
#include "rbpa/fill.h"
#include "rbpa/plane/alpha_complex.h"
#include "support/random.h"

TEST_SUITE_BEGIN("fill");

namespace {

using rbpa::fill;
using rbpa::Filling;
using rbpa::FillOptions;
using rbpa::Point;
using rbpa::Polygon;
using rbpa_test::Points;
using rbpa_test::Random;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Puts each polygon into a group of its own.
std::vector<std::size_t> one_by_one(const std::vector<Polygon>& polygons) {
  std::vector<std::size_t> groups(polygons.size());
  for (std::size_t i = 0; i < groups.size(); ++i) groups[i] = i;
  return groups;
}

void check_groups(const Points& points, const std::vector<Polygon>& polygons, FillOptions options) {
  const std::vector<std::size_t> groups = one_by_one(polygons);
  options.groups = groups;
  const Filling filling = fill(points, polygons, options);
  const bool keeps = options.keep_boundary || options.size == infinity;
  CHECK(rbpa_test::wrong_with_groups(filling, points, polygons, groups, keeps) == "");
}

/// Returns all triangles of random points, as rings that begin anywhere and have either direction.
std::vector<Polygon> parcels(const Points& points, Random& random) {
  std::vector<Polygon> parcels;
  for (const auto& triangle : rbpa::alpha_complex(points, infinity).triangles) {
    std::vector<std::uint32_t> ring(triangle.begin(), triangle.end());
    std::rotate(ring.begin(), ring.begin() + random.integer(0, 2), ring.end());
    if (random.integer(0, 1) == 0) std::reverse(ring.begin(), ring.end());
    parcels.push_back({.shell = {ring}});
  }
  return parcels;
}

}  // namespace

TEST_CASE("three parcels that share edges are filled, and their triangles meet in whole edges") {
  // The third parcel has a vertex in the middle of an edge where the others have none.
  const Points points = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {8, 0}, {8, 3}, {0, 6}, {8, 6}, {6, 3}};
  const std::vector<Polygon> polygons = {
      {.shell = {{0, 1, 2, 3}}}, {.shell = {{1, 2, 5, 4}}}, {.shell = {{3, 2, 8, 5, 7, 6}}}};
  for (const double size : {0.4, 5.0, infinity}) {
    INFO("size ", size);
    check_groups(points, polygons, {.size = size});
    const std::vector<std::size_t> groups = {0, 1, 2};
    const Filling filling = fill(points, polygons, {.size = size, .groups = groups});
    std::size_t open = 0;
    double outline = 0;
    for (std::size_t t = 0; t < filling.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        if (filling.neighbors[t][k] != rbpa::TriangleArrays::none) continue;
        const Point& a = filling.points[filling.triangles[t][(k + 1) % 3]];
        const Point& b = filling.points[filling.triangles[t][(k + 2) % 3]];
        outline += std::abs(b.x - a.x) + std::abs(b.y - a.y);
        ++open;
      }
    CHECK(outline == doctest::Approx(28));
    CHECK(open >= 7);
  }
  CHECK(rbpa_test::refusal(points, polygons).find("runs along") != std::string::npos);  // as one group
}

TEST_CASE("parcels on random points are filled: whole, cut, graded, kept, without a size") {
  Random random(11);
  for (int i = 0; i < 24; ++i) {
    Points points;
    const double stretch = i % 3 == 0 ? 0x1p-30 : 1;  // slivers, whose cuts do not fit double
    for (int k = random.integer(4, 30); k > 0; --k)
      points.push_back({double(random.integer(0, 30)) / 3 + 1e3, 1e3 + stretch * double(random.integer(0, 30)) / 3});
    INFO("number ", i);
    std::vector<Polygon> polygons = parcels(points, random);
    if (polygons.empty()) continue;
    std::shuffle(polygons.begin(), polygons.end(), std::minstd_rand(static_cast<unsigned>(i)));
    check_groups(points, polygons, {.size = random.between(0.3, 4)});
    if (stretch == 1) check_groups(points, polygons, {.size = 4, .grade = 0.5});
    check_groups(points, polygons, {.size = 1, .keep_boundary = true});
    check_groups(points, polygons, {.size = infinity});
  }
}

TEST_CASE("an edge that one parcel has to keep whole stays whole in its neighbor") {
  Random random(13);
  std::size_t filled = 0, whole = 0;
  for (int i = 0; i < 100; ++i) {
    // An edge of a hole lies below the slanted edge between the parcels, some units in the last place away.
    const Point a{0, random.between(1, 2)}, b{1, random.between(1, 2)};
    const auto below = [&](double share) {
      double y = a.y + share * (b.y - a.y);
      for (int step = random.integer(1, 2); step > 0; --step) y = std::nextafter(y, 0);
      return Point{share, y};
    };
    const Points points = {{0, 0}, {1, 0}, b, a, below(0.125), below(0.875), {0.5, 0.25}, {1, 3}, {0, 3}};
    std::vector<Polygon> polygons = {{.shell = {{0, 1, 2, 3}}, .holes = {{{4, 5, 6}}}}, {.shell = {{3, 2, 7, 8}}}};
    if (i % 2 == 0) std::swap(polygons[0], polygons[1]);
    if (rbpa_test::refusal(points, polygons, {.size = 3, .groups = one_by_one(polygons)}) != "") continue;  // they meet
    ++filled;
    check_groups(points, polygons, {.size = 0.07});
    const Filling filling = fill(points, polygons, {.size = 0.07, .groups = one_by_one(polygons)});
    const auto& ring = filling.polygons[i % 2 == 0 ? 0 : 1].shell.points;
    const auto at = static_cast<std::size_t>(std::find(ring.begin(), ring.end(), 3U) - ring.begin());
    whole += ring[(at + 1) % ring.size()] == 2 || ring[(at + ring.size() - 1) % ring.size()] == 2;
  }
  CHECK(filled > 30);
  CHECK(whole > 0);
}

TEST_CASE("features that overlap or are repeated are filled separately") {
  Random random(12);
  std::size_t filled = 0;
  for (int i = 0; i < 150; ++i) {
    INFO("number ", i);
    Points points;
    std::vector<Polygon> polygons;
    for (int k = random.integer(2, 7); k > 0; --k) {
      if (!polygons.empty() && random.integer(0, 4) == 0) {
        polygons.push_back(polygons[random.below(polygons.size())]);
        continue;
      }
      const auto first = static_cast<std::uint32_t>(points.size());
      for (int j = 0; j < 3; ++j) points.push_back({double(random.integer(0, 4)), double(random.integer(0, 4))});
      const Polygon polygon{.shell = {{first, first + 1, first + 2}}};
      if (rbpa_test::refusal(points, {polygon}, {.size = infinity}) == "") polygons.push_back(polygon);
    }
    if (polygons.empty()) continue;
    ++filled;
    check_groups(points, polygons, {.size = infinity});
    check_groups(points, polygons, {.size = 1});
  }
  CHECK(filled > 100);
}

TEST_CASE("groups that do not ascend from 0 are refused, and empty groups are ignored") {
  const Points points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const std::vector<Polygon> polygons = {rbpa_test::square(), {}, rbpa_test::square()};
  for (const std::vector<std::size_t>& bad : {std::vector<std::size_t>{1}, {0, 2, 1}, {0, 9}}) {
    CHECK(rbpa_test::refusal(points, polygons, {.size = 1, .groups = bad})
              .find("groups: found numbers that do not ascend from 0 to at most ") == 0);
  }
  const std::vector<std::size_t> groups = {0, 1, 1, 2};
  const Filling filling = fill(points, polygons, {.size = 9, .groups = groups});
  CHECK(filling.triangles.size() == 4);
  CHECK(filling.groups == std::vector<std::size_t>{0, 3, 0, 3});
  CHECK(rbpa_test::wrong_with_groups(filling, points, polygons, groups, false) == "");
}

TEST_SUITE_END();

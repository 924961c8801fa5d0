#include "rbpa/hrbpa.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "far_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/base/exact/magnitude.h"
#include "rbpa/plane/predicate/radius.h"
#include "rbpa/rbpa.h"
#include "support/check_ascending.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/levels.h"
#include "support/random.h"
#include "support/refusal_of.h"
#include "support/sets.h"
#include "support/shrink.h"
#include "support/spacing.h"
#include "support/text.h"
#include "support/triangle.h"

using namespace rbpa_test;
using rbpa::Hierarchy;
using rbpa::Point;

TEST_SUITE_BEGIN("hierarchy");

namespace {

bool admits(const Point& a, const Point& b, const Point& c, double alpha) {
  return (std::isinf(alpha) ? rbpa::Radius() : rbpa::Radius(alpha)).admits<long double>(a, b, c);
}

/// Returns the first difference of hrbpa() from rbpa().
std::string wrong_with_hierarchy(const Points& points, double alpha, std::size_t leaf_capacity) {
  const Hierarchy h = hierarchy(points, alpha, leaf_capacity);
  const rbpa::SolidAlphaComplex direct = rbpa::rbpa(points, alpha);
  if (std::string wrong = difference(rbpa::triangles(direct), rbpa::triangles(h.complex)); !wrong.empty()) return wrong;
  if (h.complex.isolated != direct.isolated) return "isolated points";
  if (h.complex.duplicates != direct.duplicates || h.complex.distinct != direct.distinct) return "duplicates";
  if (h.complex.mesh.n_vertices() != direct.mesh.n_vertices() || h.complex.mesh.n_edges() != direct.mesh.n_edges())
    return "vertices or edges";
  if (std::string wrong = wrong_numbers(h, alpha); !wrong.empty()) return wrong;
  if (std::string wrong = wrong_level(h, points, admits); !wrong.empty()) return wrong;
  if (!h.levels.empty() && h.levels.front().triangles != rbpa::rbpa(points, h.levels.front().alpha).mesh.n_faces())
    return "triangles of the first level";
  return "";
}

void check_law_of_the_levels(const Points& points, double alpha, std::size_t leaf_capacity) {
  CAPTURE(alpha);
  CAPTURE(leaf_capacity);
  const std::string wrong = wrong_with_hierarchy(points, alpha, leaf_capacity);
  if (wrong.empty()) return;
  const Points few =
      shrink(points, [&](const Points& some) { return !wrong_with_hierarchy(some, alpha, leaf_capacity).empty(); });
  FAIL_CHECK(wrong, "\nshrunk: ", wrong_with_hierarchy(few, alpha, leaf_capacity), "\n", literal(few));
}

/// Returns the message of a refusal; "" when there is none.
std::string refusal(const Points& points, double alpha, std::size_t leaf_capacity = 64) {
  return refusal_of<std::exception>([&] {
    rbpa::hrbpa(points, alpha, {.leaf_capacity = leaf_capacity, .progress = [](const rbpa::Progress&) -> bool {
                                  throw std::string("computed before it was checked");
                                }});
  });
}

/// Returns points on a parabola so flat that every circumradius is far above their diameter.
Points flat_parabola(int count, double curvature) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double x = i + 0.001 * (i * i % 7);
    points.push_back({x, curvature * x * x});
  }
  return points;
}

/// Returns points whose density falls with the square of the distance from the center, over three decades.
Points heavy_center(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Points points;
  while (points.size() < count) {
    const double x = random.between(-1, 1), y = random.between(-1, 1), square = x * x + y * y;
    if (square > 1 || square == 0) continue;
    // The area inside r grows with r² for uniform points, and here with log(1 + (r/core)²).
    constexpr double core = 1e-3;
    const double r = core * std::sqrt(std::expm1(square * std::log1p(1 / (core * core)))) / std::sqrt(square);
    points.push_back({r * x, r * y});
  }
  return points;
}

/// Returns points of which half are uniform in the unit square, and half in clusters of width 10⁻¹, 10⁻² and 10⁻³.
Points three_decades(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.unit(), y = random.unit();
    const double width = i % 2 == 0 ? 1 : i % 6 == 1 ? 0.1 : i % 6 == 3 ? 0.01 : 0.001;
    const double at = i % 2 == 0 ? 0 : i % 6 == 1 ? 0.2 : i % 6 == 3 ? 0.5 : 0.8;
    points.push_back({at + width * x, at + width * y});
  }
  return points;
}

}  // namespace

TEST_CASE("after every level the mesh is the complex of its radius, in the end that of alpha") {
  for (const NamedSet& set : generated_sets()) {
    const Points points = set.first(100), some = set.some(100);
    CAPTURE(set.name);
    for (const std::size_t k : {1u, 6u, 64u}) check_law_of_the_levels(points, infinity, k);
    for (const double alpha : set.alphas) check_law_of_the_levels(points, alpha, 4);
    check_law_of_the_levels(some, infinity, 3);
    for (const double alpha : set.alphas) check_law_of_the_levels(some, alpha, 16);
  }
}

TEST_CASE("the complex of a level is that of rbpa() for its radius") {
  for (const Points& points : {uniform(300, 1), sparse_grid(20, 0.4, 2), clusters(20, 3), star(325)}) {
    const Hierarchy h = hierarchy(points, infinity, 2);
    REQUIRE(h.levels.size() >= 3);
    for (const rbpa::Level& level : h.levels) {
      const auto direct = rbpa::triangles(rbpa::rbpa(points, level.alpha));
      REQUIRE(direct.size() == level.triangles);
      REQUIRE(direct == rbpa::triangles(hierarchy(points, level.alpha, 2).complex));
    }
  }
}

TEST_CASE("pivots and seeds, which replace tiles at extreme exponents, find the same triangles and levels") {
  for_each_far_set([&](std::string_view name, const Points& points, const Points& far) {
    const double spacing = mean_spacing(points);
    for (const double alpha : {0.6 * spacing, 3 * spacing, infinity}) {
      INFO(name, ", alpha ", alpha);
      const Hierarchy by_tiles = hierarchy(points, alpha, 16),
                      by_pivots = hierarchy(far, std::ldexp(alpha, far_exponent), 16);
      CHECK(difference(rbpa::triangles(by_tiles.complex), rbpa::triangles(by_pivots.complex)) == "");
      REQUIRE(by_tiles.levels.size() == by_pivots.levels.size());
      for (std::size_t i = 0; i < by_tiles.levels.size(); ++i)
        CHECK(by_tiles.levels[i].triangles == by_pivots.levels[i].triangles);
      check_law_of_the_levels(far, std::ldexp(alpha, far_exponent), 16);
    }
  });
}

TEST_CASE("circumradii far above the diameter are reached without a radius for them, however few levels there are") {
  for (const double curvature : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 1e-12})
    for (const int count : {4, 10, 20, 40, 100})
      for (const std::size_t k : {1u, 16u, 64u}) {
        CAPTURE(curvature);
        CAPTURE(count);
        check_law_of_the_levels(flat_parabola(count, curvature), infinity, k);
        check_law_of_the_levels(flat_parabola(count, curvature), 0.6 / curvature, k);
        check_law_of_the_levels(flat_parabola(count, curvature), 1e300, k);
      }
}

TEST_CASE("random sets on small grids obey the law of the levels for any capacity") {
  for (int number = 0; number < 4000; ++number) {
    CAPTURE(number);
    Random random(static_cast<std::uint64_t>(number));
    const Points points = random_grid(random.integer(2, 9), random.below(28) + 3, random.chance(0.2), random.bits());
    const double alpha = random.chance(0.3) ? infinity : 0.25 * random.integer(1, 20);
    check_law_of_the_levels(points, alpha, random.below(6) + 1);
  }
}

TEST_CASE("the triangles, and the levels that add some, do not depend on the order of the input") {
  // The test of a site depends on the order of sites, so there may be additional levels without changes.
  using Growth = std::vector<std::pair<double, std::size_t>>;
  const auto growth = [](const Hierarchy& h) {
    Growth found;
    std::size_t before = 0;
    for (const rbpa::Level& level : h.levels) {
      if (level.triangles > before) found.emplace_back(level.alpha, level.triangles);
      before = level.triangles;
    }
    return found;
  };
  Random random(31);
  for (const NamedSet& set : generated_sets()) {
    Points points = set.first(100);
    Points shuffled = points;
    random.shuffle(shuffled);
    CAPTURE(set.name);
    const Hierarchy one = hierarchy(points, infinity, 5), other = hierarchy(shuffled, infinity, 5);
    CHECK(difference(rbpa::triangles(one.complex), translated(rbpa::triangles(other.complex), shuffled, points)) == "");
    CHECK(one.least_radius == other.least_radius);
    CHECK(growth(one) == growth(other));
  }
}

TEST_CASE("invalid radii and points are refused by name before anything is computed") {
  const Points points = uniform(5000, 1);
  for (const double alpha : {0.0, -0.0, -1.5, -infinity, std::nan("")}) {
    CAPTURE(alpha);
    CHECK(contains(refusal(points, alpha), "alpha"));
  }
  CHECK(contains(refusal(points, -1.5), "-1.5"));
  for (const double bad : {std::nan(""), infinity, -infinity}) {
    const std::string said = refusal({{0, 0}, {1, 0}, {bad, 2.5}, {0, bad}}, 1);
    CHECK(contains(said, "point 2"));
    CHECK(contains(said, "2.5"));
  }
  CHECK(contains(refusal(points, 1, 0), "leaf_capacity"));
  CHECK(contains(refusal({}, 1, 0), "leaf_capacity"));
}

TEST_CASE("fewer than three points, or points on a line, have no levels and no triangle") {
  Points line;
  for (const int i : {4, 1, 5, 0, 3, 7, 2, 6}) line.push_back({3.0 * i, -7.0 * i});
  for (const Points& points : {Points{}, Points{{1, 2}}, Points{{1, 2}, {3, 4}}, Points(100, Point{0.1, 0.2}), line}) {
    for (const double alpha : {1e-300, 1.0, 1e300, infinity}) {
      const Hierarchy h = hierarchy(points, alpha, 1);
      const rbpa::SolidAlphaComplex direct = rbpa::rbpa(points, alpha);
      CHECK(h.levels.empty());
      CHECK(h.least_radius == 0);
      CHECK(h.complex.mesh.n_faces() == 0);
      CHECK(h.complex.isolated == direct.isolated);
      CHECK(h.complex.duplicates == direct.duplicates);
      CHECK(h.complex.distinct == direct.distinct);
    }
  }
}

TEST_CASE("a radius below the least gives one level") {
  const Points points = uniform(200, 3);
  const double least = hierarchy(points, infinity, 4).least_radius;
  for (const double alpha : {least, std::nextafter(least, 0.0), least / 7, 5e-324}) {
    const Hierarchy h = hierarchy(points, alpha, 4);
    REQUIRE(h.levels.size() == 1);
    CHECK(h.levels[0].alpha == alpha);
    CHECK(h.levels[0].number == 0);
  }
}

TEST_CASE("progress ascends, true changes nothing, and false cancels at once") {
  const Points points = jittered_grid(120, 0.8, 1);
  std::vector<rbpa::Progress> seen;
  const Hierarchy watched = rbpa::hrbpa(points, infinity, {.progress = [&](const rbpa::Progress& p) {
                                          seen.push_back(p);
                                          return true;
                                        }});
  check_ascending(seen, points.size(), watched.complex.mesh.n_faces());
  CHECK(rbpa::triangles(watched.complex) == rbpa::triangles(rbpa::rbpa(points, infinity)));
  for (const int last : {1, 2}) {
    int calls = 0;
    CHECK_THROWS_AS(rbpa::hrbpa(points, 2, {.progress = [&](const rbpa::Progress&) { return ++calls < last; }}),
                    rbpa::Cancelled);
    CHECK(calls == last);
  }
}

TEST_CASE("a close pair among uniform points costs few levels, in which few points take part") {
  Points points = uniform(20000, 4);
  const Hierarchy without = hierarchy(points, infinity, 1);
  points.push_back({points[77].x + 1e-12, points[77].y});
  const Hierarchy with = hierarchy(points, infinity, 1);
  CHECK(wrong_numbers(with, infinity) == "");
  CHECK(with.least_radius < 1e-11);
  // About forty doublings separate the pair from its neighbors.
  CHECK(with.levels.size() <= without.levels.size() + 8);
  std::size_t extra = 0;
  for (const rbpa::Level& level : with.levels)
    if (level.number > 0 && level.alpha < without.least_radius) extra += level.taking_part;
  CHECK(extra < 100);
}

TEST_CASE("over all levels at most four times as many points take part as there are points") {
  const struct {
    const char* name;
    Points points;
  } sets[] = {{"uniform", uniform(20000, 5)},           {"jittered", jittered_grid(140, 0.9, 6)},
              {"grid", perfect_grid(140, 1)},           {"three decades", three_decades(20000, 7)},
              {"heavy center", heavy_center(20000, 8)}, {"lidar", lidar_lines(100, 200, 9)}};
  for (const auto& set : sets)
    for (const std::size_t k : {1u, 4u, 16u, 64u, 1024u}) {
      CAPTURE(std::string(set.name));
      CAPTURE(k);
      const Hierarchy h = hierarchy(set.points, infinity, k);
      CHECK(wrong_numbers(h, infinity) == "");
      CHECK(sum_of_taking_part(h) <= 4 * h.complex.distinct);
    }
}

TEST_SUITE_END();

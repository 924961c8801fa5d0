#include "rbpa/space/surface/normals/outer_sides.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numeric>
#include <string>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/surface/estimate_normals.h"
#include "rbpa/space/surface/normals/fit_plane.h"
#include "support/space_sets.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::Point3;

TEST_SUITE_BEGIN("space");

namespace {

using Height = std::function<double(double, double)>;

struct Known {
  std::string name;
  Points3 points, normals;
};

/// Returns points over the square from −1 to 1: random on both sides of a sheet of some thickness and on its rim, or on
/// the one side of a sheet of thickness 0; moved by noise.
Known sheet(const std::string& name, std::size_t count, double thickness, double noise, const Height& height) {
  Random random(91);
  Known known{.name = name, .points = {}, .normals = {}};
  const auto normal = [&](double x, double y) {
    constexpr double step = 1e-5;
    const double u = (height(x + step, y) - height(x - step, y)) / (2 * step);
    const double v = (height(x, y + step) - height(x, y - step)) / (2 * step);
    const double length = std::sqrt(1 + u * u + v * v);
    return Point3{-u / length, -v / length, 1 / length};
  };
  const auto add = [&](double x, double y, double out, double side) {
    const Point3 n = normal(x, y);
    const double d = out + noise * random.between(-1, 1);
    known.points.push_back({x + d * n.x, y + d * n.y, height(x, y) + d * n.z});
    known.normals.push_back({side * n.x, side * n.y, side * n.z});
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double side = thickness > 0 && random.chance(0.5) ? -1 : 1;
    add(random.between(-1, 1), random.between(-1, 1), side * thickness / 2, side);
  }
  for (std::size_t i = 0; thickness > 0 && i < count / 20; ++i) {
    const double along = random.between(-1, 1), end = random.chance(0.5) ? 1 : -1;
    const bool is_x = random.chance(0.5);
    add(is_x ? end : along, is_x ? along : end, thickness * random.between(-0.5, 0.5), 1);
    known.normals.back() = is_x ? Point3{end, 0, 0} : Point3{0, end, 0};
  }
  return known;
}

Known ball(std::size_t count) {
  Random random(92);
  Known known{.name = "ball", .points = {}, .normals = {}};
  while (known.points.size() < count) {
    const Point3 p = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (length(p) < 0.1 || length(p) > 1) continue;
    known.normals.push_back(unit(p));
    known.points.push_back(known.normals.back());
  }
  return known;
}

double right_share(const Known& known, const Points3& normals) {
  std::size_t right = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) right += dot(normals[i], known.normals[i]) > 0;
  return static_cast<double>(right) / static_cast<double>(normals.size());
}

/// Returns the sides that a ball finds, for planes with the true normals, some of them turned.
std::vector<std::int8_t> sides_of(const Known& known, const std::function<bool(std::size_t)>& is_turned,
                                  const rbpa::SurfaceOptions& options = {}) {
  std::vector<std::size_t> order(known.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return known.points[i] < known.points[j]; });
  Points3 points;
  for (const std::size_t i : order) points.push_back(known.points[i]);
  rbpa::Threads threads(1);
  auto [near, normals, flatness] = rbpa::space::fit_planes<double>(points, 16, threads, {});
  for (std::size_t k = 0; k < order.size(); ++k) {
    Point3& n = normals[near.place[k]];
    const bool is_wrong = dot(n, known.normals[order[k]]) < 0;
    if (is_wrong != is_turned(k)) n = {-n.x, -n.y, -n.z};
  }
  return rbpa::space::outer_sides(near, normals, options).side;
}

const Height flat = [](double, double) { return 0.0; }, saddle = [](double x, double y) { return 0.4 * x * y; },
             waves = [](double x, double y) { return 0.2 * std::sin(4 * x + y); };

}  // namespace

TEST_CASE("nearly all normals are outward on solids thinner than the spacing of points") {
  for (const Known& known : {sheet("plate", 6000, 0.02, 0, flat), sheet("thinner plate", 6000, 0.01, 0, flat),
                             sheet("rough plate", 6000, 0.02, 0.001, flat), sheet("saddle", 6000, 0.02, 0, saddle),
                             sheet("waves", 12'000, 0.01, 0, waves), sheet("a few", 900, 0.04, 0, flat)}) {
    CAPTURE(known.name);
    CHECK(right_share(known, rbpa::estimate_normals(known.points)) > 0.95);
  }
}

TEST_CASE("open sheets, level, with crests and valleys, or rough, are not turned") {
  for (const double noise : {0.0, 0.1, 0.3, 0.6})
    for (const std::size_t count : {900u, 6000u})
      for (const Height& height : {flat, saddle, waves}) {
        CAPTURE(noise);
        CAPTURE(count);
        const Known known = sheet("open", count, 0, noise * 2 / std::sqrt(static_cast<double>(count)), height);
        CHECK(right_share(known, rbpa::estimate_normals(known.points)) == 1);
      }
}

TEST_CASE("a solid with right normals is left alone; one inside out is turned where the ball sees it") {
  const Known known = ball(3000);
  for (const std::int8_t side : sides_of(known, [](std::size_t) { return false; })) CHECK(side == 0);
  const auto sides = sides_of(known, [](std::size_t) { return true; });
  REQUIRE(sides.size() == known.points.size());
  CHECK(std::count(sides.begin(), sides.end(), 1) == 0);
  CHECK(std::count(sides.begin(), sides.end(), -1) > 2800);
  // One point in twenty that is turned is a contradiction, one in a hundred is not.
  const auto some = sides_of(known, [](std::size_t i) { return i < 150; });
  CHECK(std::count(some.begin(), some.end(), -1) > 140);
  const auto few = sides_of(known, [](std::size_t i) { return i < 30; });
  CHECK(std::count(few.begin(), few.end(), -1) == 0);
}

TEST_CASE("components are judged separately") {
  Known known = ball(1000);
  for (std::size_t i = 0; i < 1000; ++i) {
    known.points.push_back({known.points[i].x + 5, known.points[i].y, known.points[i].z});
    known.normals.push_back(known.normals[i]);
  }
  // Points are sorted by x, so that the first half is one ball.
  const auto sides = sides_of(known, [](std::size_t i) { return i < 1000; });
  REQUIRE(sides.size() == 2000);
  CHECK(std::count(sides.begin(), sides.end(), -1) > 900);
  CHECK(std::count(sides.begin(), sides.end(), -1) <= 1000);
  CHECK(std::count(sides.begin(), sides.end(), 1) == 0);
}

TEST_CASE("the sides do not depend on the order of the points, the threads or a power of two") {
  const Known known = sheet("plate", 4000, 0.02, 0, saddle);
  const Points3 expected = rbpa::estimate_normals(known.points, {.threads = 1});
  std::vector<std::uint32_t> order(known.points.size());
  std::iota(order.begin(), order.end(), 0u);
  Random(93).shuffle(order);
  Points3 shuffled, expected_shuffled;
  for (const std::uint32_t i : order) {
    const Point3& p = known.points[i];
    shuffled.push_back({std::ldexp(p.x, -7), std::ldexp(p.y, -7), std::ldexp(p.z, -7)});
    expected_shuffled.push_back(expected[i]);
  }
  const Points3 found = rbpa::estimate_normals(shuffled, {.threads = 2});
  CHECK(std::memcmp(found.data(), expected_shuffled.data(), found.size() * sizeof(Point3)) == 0);
}

TEST_CASE("the search for sides can be cancelled") {
  const Known known = sheet("plate", 3000, 0.02, 0, flat);
  std::size_t asked = 0;
  const auto count = [&](const rbpa::Progress&) {
    ++asked;
    return true;
  };
  const auto all = [](std::size_t i) { return i % 2 == 0; };
  sides_of(known, all, {.threads = 1, .progress = count});
  REQUIRE(asked > 4);
  for (const std::size_t until : {std::size_t{1}, asked / 2, asked}) {
    std::size_t left = until;
    const auto stop = [&](const rbpa::Progress&) { return --left > 0; };
    CHECK_THROWS_AS(sides_of(known, all, {.threads = 1, .progress = stop}), rbpa::Cancelled);
  }
}

TEST_SUITE_END();

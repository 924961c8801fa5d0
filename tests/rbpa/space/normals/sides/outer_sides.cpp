#include "rbpa/space/normals/sides/outer_sides.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/normals/estimate_normals.h"
#include "rbpa/space/surface/neighbors/find_nearest.h"
#include "space/simplify/triangle_sets.h"
#include "support/data_folder.h"
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

/// Returns points on a sphere, moved by noise in spacings, above height `lowest`; normals point into it if `side` is
/// negative.
Known ball(std::size_t count, double radius = 1, double side = 1, double noise = 0, double lowest = -1) {
  Random random(92 + count);
  Known known{.name = "ball", .points = {}, .normals = {}};
  while (known.points.size() < count) {
    const Point3 p = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (length(p) < 0.1 || length(p) > 1 || unit(p).z < lowest) continue;
    known.normals.push_back(side * unit(p));
    const double spacing = radius * std::sqrt(4 * std::numbers::pi / static_cast<double>(count));
    known.points.push_back((radius + noise * spacing * random.between(-1, 1)) * unit(p));
  }
  return known;
}

/// Returns points spread over the triangles of a closed mesh, moved by noise in spacings, with the triangles' normals.
Known spread(const std::string& name, std::size_t count, double noise) {
  const Triangles mesh = read_off(bundled_data() / (name + ".off"));
  std::vector<double> area = {0};
  const auto cross_of = [&](std::size_t t) {
    const auto& [a, b, c] = mesh.corners[t];
    return cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
  };
  for (std::size_t t = 0; t < mesh.corners.size(); ++t) area.push_back(area.back() + length(cross_of(t)) / 2);
  const double spacing = std::sqrt(area.back() / static_cast<double>(count));
  Random random(95);
  Known known{.name = name, .points = {}, .normals = {}};
  while (known.points.size() < count) {
    const auto last = std::upper_bound(area.begin(), area.end(), random.between(0, area.back()));
    const auto t = static_cast<std::size_t>(last - area.begin()) - 1;
    if (t >= mesh.corners.size()) continue;
    double u = random.unit(), v = random.unit();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const auto& [a, b, c] = mesh.corners[t];
    const Point3 n = unit(cross_of(t));
    known.normals.push_back(n);
    known.points.push_back(mesh.points[a] + u * (mesh.points[b] - mesh.points[a]) +
                           v * (mesh.points[c] - mesh.points[a]) + noise * spacing * random.between(-1, 1) * n);
  }
  return known;
}

double right_share(const Known& known, const Points3& normals) {
  std::size_t right = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) right += dot(normals[i], known.normals[i]) > 0;
  return static_cast<double>(right) / static_cast<double>(normals.size());
}

using Directions = std::function<Point3(std::size_t)>;

struct Found {
  Points3 normals;
  std::vector<std::int8_t> side;
};

/// Returns the sides of points, in their order, for planes with the given normals.
Found sides_of(const Known& known, const Directions& normal, const rbpa::SolidOptions& options = {}) {
  std::vector<std::size_t> order(known.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return known.points[i] < known.points[j]; });
  Points3 points;
  for (const std::size_t i : order) points.push_back(known.points[i]);
  rbpa::Threads threads(1);
  const rbpa::space::Neighborhoods near = rbpa::space::find_nearest<double>(points, 16, threads, {});
  Points3 normals(points.size());
  for (std::size_t k = 0; k < order.size(); ++k) normals[near.place[k]] = normal(order[k]);
  const rbpa::space::OuterSides sides = rbpa::space::outer_sides(near, normals, options);
  Found found = {.normals = known.normals, .side = std::vector<std::int8_t>(sides.empty() ? 0 : points.size())};
  for (std::size_t k = 0; k < order.size() && !sides.empty(); ++k) {
    found.normals[order[k]] = normals[near.place[k]];
    found.side[order[k]] = sides.side[near.place[k]];
  }
  return found;
}

Known operator+(Known a, const Known& b) {
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
  return a;
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

TEST_CASE("nearly all normals are outward on closed bodies, with noise and with outliers") {
  constexpr double nearly_all = 0.9995;
  for (const std::string name : {"m3_bob", "m3_spot", "m3_torus"}) {
    CAPTURE(name);
    const Known known = spread(name, 6000, 0), noisy = spread(name, 6000, 0.3);
    CHECK(right_share(known, rbpa::estimate_normals(known.points)) >= nearly_all);
    CHECK(right_share(noisy, rbpa::estimate_normals(noisy.points)) >= nearly_all);
    Random random(96);
    Points3 points = known.points;
    for (int i = 0; i < 120; ++i)
      points.push_back({random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
    Points3 normals = rbpa::estimate_normals(points);
    normals.resize(known.points.size());
    CHECK(right_share(known, normals) >= nearly_all);
  }
}

TEST_CASE("a tenth of outliers does not turn a sphere inside out") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const Known known = ball(20'000);
    Random random(seed);
    Points3 points = known.points;
    for (int i = 0; i < 2000; ++i)
      points.push_back({random.between(-1.2, 1.2), random.between(-1.2, 1.2), random.between(-1.2, 1.2)});
    Points3 normals = rbpa::estimate_normals(points);
    normals.resize(known.points.size());
    CHECK(right_share(known, normals) > 0.999);
  }
}

TEST_CASE("the wall of a cavity faces into the cavity, a body within it outward") {
  for (const double noise : {0.0, 0.3}) {
    const Known known =
        ball(4000, 1, 1, noise) + ball(2500, 0.8, -1, noise) + ball(1000, 0.5, 1, noise) + ball(500, 0.35, -1, noise);
    CHECK(right_share(known, rbpa::estimate_normals(known.points)) >= (noise > 0 ? 0.999 : 1));
  }
}

TEST_CASE("the sides do not depend on which way normals point") {
  const Known known = sheet("plate", 4000, 0.05, 0, saddle);
  const auto true_normal = [&](std::size_t i) { return known.normals[i]; };
  const auto turned = [](std::size_t i) { return i % 3 == 0; };
  const Found found = sides_of(known, true_normal);
  REQUIRE(found.side.size() == known.points.size());
  CHECK(std::count(found.side.begin(), found.side.end(), 1) > 4100);
  CHECK(std::count(found.side.begin(), found.side.end(), -1) < 20);
  const Found other = sides_of(known, [&](std::size_t i) { return (turned(i) ? -1.0 : 1.0) * known.normals[i]; });
  for (std::size_t i = 0; i < known.points.size(); ++i) {
    const bool is_replaced = found.normals[i] != known.normals[i];
    CHECK(other.side[i] == (turned(i) && !is_replaced ? -found.side[i] : found.side[i]));
  }
}

TEST_CASE("a normal in the surface is replaced by an outward one") {
  const Known known = ball(3000);
  const Found found = sides_of(known, [&](std::size_t i) {
    const Point3& n = known.normals[i];
    return unit(std::abs(n.x) < 0.5 ? Point3{0, n.z, -n.y} : Point3{-n.z, 0, n.x});
  });
  REQUIRE(found.side.size() == known.points.size());
  for (std::size_t i = 0; i < known.points.size(); ++i) {
    CHECK(found.side[i] == 1);
    CHECK(dot(found.normals[i], known.normals[i]) > 0.95);
    CHECK(std::abs(dot(found.normals[i], found.normals[i]) - 1) < 1e-12);
  }
}

TEST_CASE("components are judged separately: open ones are left to the tree, and keep their normals") {
  Known known = ball(2000) + ball(1500, 1, 1, 0, 0.2) + sheet("open", 1500, 0, 0.02, waves);
  for (std::size_t i = 2000; i < 5000; ++i) known.points[i].x += i < 3500 ? 5 : 10;
  const Found found = sides_of(known, [&](std::size_t i) { return known.normals[i]; });
  REQUIRE(found.side.size() == known.points.size());
  for (std::size_t i = 0; i < known.points.size(); ++i) CHECK(found.side[i] == (i < 2000 ? 1 : 0));
  CHECK(found.normals == known.normals);
}

TEST_CASE("fewer than four points, and points in a plane, have no sides") {
  const auto upward = [](std::size_t) { return Point3{0, 0, 1}; };
  Known level{.name = "level", .points = {}, .normals = {}};
  for (int i = 0; i < 100; ++i) {
    level.points.push_back({double(i % 10), double(i / 10), 0.5});
    if (i < 4) CHECK(sides_of(level, upward).side.empty());
  }
  CHECK(sides_of(level, upward).side.empty());
}

TEST_CASE("points on curves are left to the tree, as they have too many tetrahedra") {
  Known lines{.name = "two skew lines", .points = {}, .normals = {}};
  Random random(97);
  for (int i = 0; i < 1500; ++i) {
    lines.points.push_back({random.unit(), 0, 0});
    lines.points.push_back({0.5, random.unit(), 0.3});
  }
  CHECK(sides_of(lines, [](std::size_t) { return Point3{0, 0, 1}; }).side.empty());
}

TEST_CASE("the sides do not depend on the order of the points, the threads or a power of two") {
  Random random(93);
  for (const Known& known : {sheet("plate", 4000, 0.02, 0, saddle), ball(2500, 1, 1, 0.3) + ball(1000, 0.5, -1, 0.3)}) {
    CAPTURE(known.name);
    Points3 points = known.points, expected = rbpa::estimate_normals(points, {.threads = 1});
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    for (const int exponent : {-400, -90, -7, -1, 0, 1, 3, 90, 400})
      for (const unsigned threads : {1u, 2u, 7u}) {
        random.shuffle(order);
        Points3 shuffled, expected_shuffled;
        for (const std::uint32_t i : order) {
          const Point3& p = points[i];
          shuffled.push_back({std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)});
          expected_shuffled.push_back(expected[i]);
        }
        const Points3 found = rbpa::estimate_normals(shuffled, {.threads = threads});
        CHECK(std::memcmp(found.data(), expected_shuffled.data(), found.size() * sizeof(Point3)) == 0);
      }
  }
}

TEST_CASE("the search for sides can be cancelled") {
  const Known known = sheet("plate", 3000, 0.02, 0, flat);
  const auto normal = [&](std::size_t i) { return known.normals[i]; };
  std::size_t asked = 0;
  const auto count = [&](const rbpa::Progress&) {
    ++asked;
    return true;
  };
  sides_of(known, normal, {.threads = 1, .progress = count});
  REQUIRE(asked > 4);
  for (const std::size_t until : {std::size_t{1}, asked / 2, asked}) {
    std::size_t left = until;
    const auto stop = [&](const rbpa::Progress&) { return --left > 0; };
    CHECK_THROWS_AS(sides_of(known, normal, {.threads = 1, .progress = stop}), rbpa::Cancelled);
  }
}

TEST_SUITE_END();

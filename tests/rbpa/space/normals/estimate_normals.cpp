#include "rbpa/space/normals/estimate_normals.h"

#include <doctest/doctest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/surface/surface.h"
#include "support/data_folder.h"
#include "support/one_target.h"
#include "support/order.h"
#include "support/space_sets.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::estimate_normals;
using rbpa::Point3;

TEST_SUITE_BEGIN("space");

namespace {

constexpr double pi = 3.14159265358979323846;

/// Points, and their true normals.
struct Known {
  Points3 points, normals;
  void add(const Point3& p, const Point3& n) {
    points.push_back(p);
    normals.push_back(n);
  }
};

Known sphere(std::size_t count, double noise, double radius, std::uint64_t seed) {
  Random random(seed);
  Known known;
  while (known.points.size() < count) {
    const Point3 p = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    if (dot(p, p) < 0.01 || dot(p, p) > 1) continue;
    const Point3 n = unit(p);
    const double out = radius * (1 + noise * random.between(-1, 1));
    known.add({out * n.x, out * n.y, out * n.z}, n);
  }
  return known;
}

Known torus(std::size_t count) {
  Random random(3);
  Known known;
  while (known.points.size() < count) {
    const double a = random.between(-pi, pi), b = random.between(-pi, pi);
    if (random.between(0, 1.5) > 1 + 0.5 * std::cos(b)) continue;
    const Point3 n = {std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
    known.add({std::cos(a) + 0.5 * n.x, std::sin(a) + 0.5 * n.y, 0.5 * n.z}, n);
  }
  return known;
}

/// Returns points of (x (x − 1)² (x − 2) + y²)² + z² = 1/100, of genus 2, by gradient steps from points near it.
Known double_torus(std::size_t count) {
  Random random(4);
  Known known;
  while (known.points.size() < count) {
    Point3 p = {random.between(-0.1, 2.1), random.between(-0.7, 0.7), random.between(-0.15, 0.15)}, gradient;
    double value = 1;
    for (int step = 0; step < 20 && std::abs(value) > 1e-12; ++step) {
      const double x = p.x, g = x * (x - 1) * (x - 1) * (x - 2) + p.y * p.y;
      value = g * g + p.z * p.z - 0.01;
      gradient = {2 * g * ((x - 1) * (x - 1) * (x - 2) + 2 * x * (x - 1) * (x - 2) + x * (x - 1) * (x - 1)),
                  4 * g * p.y, 2 * p.z};
      const double along = value / dot(gradient, gradient);
      p = {p.x - along * gradient.x, p.y - along * gradient.y, p.z - along * gradient.z};
    }
    if (std::abs(value) < 1e-9 && std::abs(p.x) < 3 && std::abs(p.y) < 1) known.add(p, unit(gradient));
  }
  return known;
}

/// Returns all sides of a box on a grid of pitch 1, edges and corners included, with normals away from its middle.
Known box(int x, int y, int z) {
  Known known;
  const auto outward = [](int i, int last) { return i == 0 ? -1.0 : i == last ? 1.0 : 0.0; };
  for (int i = 0; i <= x; ++i)
    for (int j = 0; j <= y; ++j)
      for (int k = 0; k <= z; ++k) {
        const Point3 n = {outward(i, x), outward(j, y), outward(k, z)};
        if (n != Point3{}) known.add({double(i), double(j), double(k)}, unit(n));
      }
  return known;
}

/// Returns the fraction of the points whose normals are on the side of the true ones.
double agreeing(const Known& known, const Points3& normals) {
  REQUIRE(normals.size() == known.points.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < normals.size(); ++i) count += dot(normals[i], known.normals[i]) > 0;
  return static_cast<double>(count) / static_cast<double>(normals.size());
}

/// Returns the mean angle to the true normals in degrees, regardless of the side.
double mean_angle(const Known& known, const Points3& normals) {
  double sum = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
    sum += std::acos(std::min(1.0, std::abs(dot(normals[i], unit(known.normals[i]))))) * 180 / pi;
  return sum / static_cast<double>(normals.size());
}

bool same_bytes(const Points3& a, const Points3& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Point3)) == 0);
}

void check_units(const Points3& normals) {
  for (const Point3& n : normals) {
    CHECK(std::abs(dot(n, n) - 1) < 1e-12);
    for (const double coordinate : {n.x, n.y, n.z}) CHECK(!(coordinate == 0 && std::signbit(coordinate)));
  }
}

/// Reads points and normals from a file of six columns of the larger collection; none where the file is missing.
Known scan(const std::string& name) {
  Known known;
  std::ifstream file(further_data() / name);
  for (std::string line; std::getline(file, line);) {
    std::istringstream numbers(line);
    Point3 p, n;
    REQUIRE((numbers >> p.x >> p.y >> p.z >> n.x >> n.y >> n.z));
    if (n != Point3{}) known.add(p, n);
  }
  return known;
}

}  // namespace

TEST_CASE("normals of closed surfaces point outward, nearly in the true direction") {
  const auto check = [](const Known& known, double angle) {
    const Points3 normals = estimate_normals(known.points);
    check_units(normals);
    CHECK(agreeing(known, normals) == 1);
    CHECK(mean_angle(known, normals) < angle);
  };
  check(sphere(4000, 0, 1, 1), 1);
  check(sphere(4000, 0.1 * std::sqrt(4 * pi / 4000), 1, 1), 2);
  check(sphere(4000, 0.5 * std::sqrt(4 * pi / 4000), 1, 1), 7);
  check(torus(4000), 3);
  check(double_torus(6000), 5);
  check(box(12, 12, 12), 7);
}

/// Returns a torus as a scanner with lines across its axis sees it: the spacing along a line is a twentieth of the
/// distance of lines.
Known scan_lines() {
  Known known;
  const int lines = 60;
  for (int line = 0; line < lines; ++line) {
    const double b = 2 * pi * line / lines, out = 1 + 0.5 * std::cos(b), between_lines = 0.5 * 2 * pi / lines;
    const int along = static_cast<int>(2 * pi * out / (between_lines / 20));
    for (int i = 0; i < along; ++i) {
      const double a = 2 * pi * (i + 0.5 * (line % 2)) / along;
      const Point3 n = {std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
      known.add({std::cos(a) + 0.5 * n.x, std::sin(a) + 0.5 * n.y, 0.5 * n.z}, n);
    }
  }
  return known;
}

TEST_CASE("on scan lines normals are those of the surface, not of a line") {
  const Known known = scan_lines();
  CHECK(known.points.size() > 100'000);
  const Points3 normals = estimate_normals(known.points);
  check_units(normals);
  CHECK(agreeing(known, normals) >= 0.999);
  CHECK(mean_angle(known, normals) < 3);
}

TEST_CASE("normals stay outward around sharp edges and on the other side of a thin plate") {
  for (const int thickness : {2, 3, 5}) {
    CAPTURE(thickness);
    const Known plate = box(40, 30, thickness);
    CHECK(agreeing(plate, estimate_normals(plate.points)) == 1);
  }
}

TEST_CASE("the normals of a plane are its own, exactly for a level plane, upward, and toward +y for a wall") {
  Random random(7);
  Points3 level, tilted, wall;
  for (int i = 0; i < 500; ++i) {
    const double u = random.between(-1, 1), v = random.between(-1, 1);
    level.push_back({u, v, 0.3});
    tilted.push_back({u, v, 2 - u + 0.5 * v});
    wall.push_back({u, 0.7, v});
  }
  for (const Point3& n : estimate_normals(level)) CHECK(n == Point3{0, 0, 1});
  for (const Point3& n : estimate_normals(tilted)) CHECK(dot(n, unit(Point3{1, -0.5, 1})) > 1 - 1e-12);
  for (const Point3& n : estimate_normals(wall)) CHECK(n.y > 1 - 1e-12);
}

TEST_CASE("the inner of two spheres is a cavity, whose normals point into it") {
  Known both = sphere(2000, 0, 3, 1);
  const Known inner = sphere(1000, 0, 1, 2);
  for (std::size_t i = 0; i < inner.points.size(); ++i) {
    const Point3& n = inner.normals[i];
    both.add(inner.points[i], {-n.x, -n.y, -n.z});
  }
  CHECK(agreeing(both, estimate_normals(both.points)) == 1);
}

TEST_CASE("neither the order of the points nor the threads nor the vector unit nor a power of two changes a byte") {
  Random random(11);
  for (int k = 0; k < space_kinds; ++k) {
    CAPTURE(name(static_cast<SpaceKind>(k)));
    for (const std::size_t size : {5u, 60u, 1500u}) {
      const Points3 points = space_set(static_cast<SpaceKind>(k), size, random);
      const Points3 expected = estimate_normals(points, {.threads = 1});
      check_units(expected);
      const std::vector<std::uint32_t> order = random_order(points.size(), random);
      Points3 shuffled, scaled, expected_shuffled;
      for (const std::uint32_t i : order) {
        shuffled.push_back(points[i]);
        expected_shuffled.push_back(expected[i]);
        scaled.push_back({std::ldexp(points[i].x, 3), std::ldexp(points[i].y, 3), std::ldexp(points[i].z, 3)});
      }
      CHECK(same_bytes(estimate_normals(shuffled, {.threads = 2}), expected_shuffled));
      CHECK(same_bytes(estimate_normals(scaled, {.threads = 5}), expected_shuffled));
      for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
        const OneTarget only(target);
        CHECK(same_bytes(estimate_normals(points), expected));
      }
    }
  }
}

TEST_CASE("normals are the same at 2^500 and 2^-500, and with both in one set") {
  const Known ball = sphere(1500, 0, 1, 5);
  const Points3 expected = estimate_normals(ball.points);
  Points3 far, near, both;
  for (const Point3& p : ball.points) {
    far.push_back({0x1p500 * p.x, 0x1p500 * p.y, 0x1p500 * p.z});
    near.push_back({0x1p-500 * p.x, 0x1p-500 * p.y, 0x1p-500 * p.z});
  }
  CHECK(same_bytes(estimate_normals(far), expected));
  CHECK(same_bytes(estimate_normals(near), expected));
  both = far;
  both.insert(both.end(), near.begin(), near.end());
  Known twice = {both, ball.normals};
  twice.normals.insert(twice.normals.end(), ball.normals.begin(), ball.normals.end());
  CHECK(agreeing(twice, estimate_normals(both)) == 1);
  constexpr double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
  check_units(estimate_normals({{{most, most, most}, {-most, most, least}, {most, -most, 0}, {least, 0, least}}}));
}

TEST_CASE("equal points count as one, and have the same normal") {
  Known ball = sphere(300, 0, 1, 6);
  const Points3 expected = estimate_normals(ball.points);
  Points3 doubled = ball.points;
  for (int times = 0; times < 30; ++times) doubled.insert(doubled.end(), ball.points.begin(), ball.points.begin() + 40);
  const Points3 normals = estimate_normals(doubled);
  CHECK(same_bytes({normals.begin(), normals.begin() + 300}, expected));
  for (std::size_t i = 300; i < normals.size(); ++i) CHECK(normals[i] == expected[(i - 300) % 40]);
  CHECK(estimate_normals({{{0.0, 1, 2}, {-0.0, 1, 2}}}) == Points3(2, {0, 0, 1}));
}

TEST_CASE("points on a line have the direction across it that is nearest to z, or y") {
  CHECK(estimate_normals({}).empty());
  CHECK(estimate_normals({{{3, 4, 5}}}) == Points3{{0, 0, 1}});
  CHECK(estimate_normals({{{3, 4, 5}, {3, 4, 5}, {3, 4, 5}}}) == Points3(3, {0, 0, 1}));
  CHECK(estimate_normals({{{3, 4, 5}, {5, 9, 5}}}) == Points3(2, {0, 0, 1}));
  CHECK(estimate_normals({{{3, 4, 5}, {3, 4, 9}}}) == Points3(2, {0, 1, 0}));
  Points3 upright, slanted;
  for (int i = 0; i < 50; ++i) {
    upright.push_back({1, 2, double(i * i)});
    slanted.push_back({3.0 * i, 0.25, 4.0 * i});
  }
  CHECK(estimate_normals(upright) == Points3(50, {0, 1, 0}));
  for (const Point3& n : estimate_normals(slanted)) CHECK(dot(n, {-0.8, 0, 0.6}) > 1 - 1e-12);
  // On a line as far as double resolves it: no three of these are exactly on a line.
  Points3 rounded;
  for (int i = 0; i < 50; ++i) rounded.push_back({0.1 * i, 0.7 * i, 0.3 * i});
  const double beside = std::hypot(0.1, 0.7), length = std::hypot(beside, 0.3);
  const Point3 expected = {-0.3 * 0.1 / (beside * length), -0.3 * 0.7 / (beside * length), beside / length};
  for (const Point3& n : estimate_normals(rounded)) CHECK(dot(n, expected) > 1 - 1e-12);
  // Three points that are not on a line: the plane through them.
  for (const Point3& n : estimate_normals({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}))
    CHECK(dot(n, unit(Point3{1, 1, 1})) > 1 - 1e-12);
}

TEST_CASE("the surface of a ball from estimated normals equals that from true ones") {
  const Known ball = sphere(1500, 0, 1, 8);
  const auto expected = rbpa::surface(ball.points, ball.normals, 0.2);
  const auto estimated = rbpa::surface(ball.points, estimate_normals(ball.points), 0.2);
  CHECK(expected.triangles.size() == 2 * ball.points.size() - 4);
  CHECK(estimated.triangles == expected.triangles);
  CHECK(estimated.neighbors == expected.neighbors);
}

TEST_CASE("further scans and models have nearly all normals on the side in the file, or on the other side") {
  struct Expected {
    const char* name;
    double share, angle;
  };
  for (const Expected& expected :
       {Expected{"c3_nefertiti.xyz", 1, 5}, Expected{"c3_hammer.xyz", 0.9998, 4},
        Expected{"c3_pcl_tum_rabbit.xyz", 1, 6}, Expected{"m3_torus.xyz", 1, 1}, Expected{"m3_quadknot.xyz", 1, 8},
        Expected{"m3_spot.xyz", 1, 8}, Expected{"m3_plane_holes.xyz", 1, 6}, Expected{"m3_wingnut.xyz", 1, 10},
        Expected{"m3_human_woman.xyz", 0.99, 9}}) {
    const auto& [name, share, angle] = expected;
    CAPTURE(expected.name);
    const Known known = scan(name);
    CHECK(known.points.empty() != has_further_data());
    if (known.points.empty()) continue;
    const Points3 normals = estimate_normals(known.points);
    CHECK(agreeing(known, normals) >= share);
    CHECK(mean_angle(known, normals) < angle);
  }
}

TEST_CASE("bad input is refused with its place") {
  constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const Points3 points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK_THROWS_WITH_AS(estimate_normals({{{0, 0, 0}, {0, nan, 0}}}),
                       "point 1 is (0, nan, 0), expected finite coordinates", rbpa::InvalidInput);
  CHECK_THROWS_WITH_AS(estimate_normals({{{infinity, 0, 0}}}), "point 0 is (inf, 0, 0), expected finite coordinates",
                       rbpa::InvalidInput);
  for (const std::size_t few : {0u, 1u})
    CHECK_THROWS_WITH_AS(estimate_normals(points, {.neighbors = few}),
                         ("normals from " + std::to_string(few) + " neighbors, expected at least 2").c_str(),
                         rbpa::InvalidInput);
  CHECK(estimate_normals(points, {.neighbors = 1'000'000}) == estimate_normals(points));
}

TEST_CASE("progress is called in every part of the work, and can cancel it there") {
  const Known ball = sphere(20'000, 0, 1, 9);
  for (const unsigned threads : {1u, 2u}) {
    std::size_t asked = 0;
    const auto ask = [&](std::size_t until) {
      asked = 0;
      estimate_normals(ball.points, {.threads = threads, .progress = [&](const rbpa::Progress& progress) {
                                       CHECK(progress.triangles == 0);
                                       CHECK(progress.points == ball.points.size());
                                       return ++asked < until;
                                     }});
    };
    ask(1'000'000);
    const std::size_t all = asked;
    CHECK(all >= 20 + 4);
    for (const std::size_t until : {std::size_t{1}, std::size_t{21}, all}) CHECK_THROWS_AS(ask(until), rbpa::Cancelled);
  }
}

TEST_CASE("normals are turned toward the viewpoint, one for all points or one for each") {
  const Known known = sphere(2000, 0, 1, 5);
  const std::vector<Point3> from = {{0.5, 0.2, -0.1}};  // inside
  const auto inward = estimate_normals(known.points, {.viewpoints = from});
  std::vector<Point3> own;  // some are inside, the others outside
  for (std::size_t i = 0; i < known.points.size(); ++i)
    own.push_back(i % 3 == 0 ? from[0] : Point3{2 * known.points[i].x, 2 * known.points[i].y, 2 * known.points[i].z});
  const auto mixed = estimate_normals(known.points, {.viewpoints = own, .threads = 2});
  auto turned = estimate_normals(known.points);
  rbpa::turn_toward(known.points, own, turned);
  CHECK(turned == mixed);
  int wrong = 0;
  for (std::size_t i = 0; i < known.points.size(); ++i) {
    wrong += dot(inward[i], known.normals[i]) > -0.9;
    wrong += dot(mixed[i], known.normals[i]) * (i % 3 == 0 ? -1 : 1) < 0.9;
  }
  CHECK(wrong == 0);
}

TEST_CASE("a viewpoint in the plane turns normals upward, and extreme coordinates do not overflow") {
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e300, 1e300, 0}};
  const std::vector<Point3> above = {{0, 0, 1e-300}}, within = {{7, 7, 0}};
  std::vector<Point3> normals = {{0, 0, -1}, {0, -1, 0}, {-1, 0, 0}, {-1e300, 0, -1e300}};
  rbpa::turn_toward(points, above, normals);
  CHECK(normals == std::vector<Point3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {-1e300, 0, -1e300}});
  normals = {{0, 0, -1}, {0, -1, 0}, {-1, 0, 0}, {0, 0, -5}};
  rbpa::turn_toward(points, within, normals);
  CHECK(normals == std::vector<Point3>{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 5}});
}

TEST_CASE("viewpoints of a wrong number, or not finite, are refused") {
  const std::vector<Point3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, two = {{0, 0, 1}, {0, 0, 2}};
  const std::vector<Point3> bad = {{0, 0, std::numeric_limits<double>::infinity()}};
  CHECK_THROWS_AS(estimate_normals(points, {.viewpoints = two}), rbpa::InvalidInput);
  CHECK_THROWS_AS(estimate_normals(points, {.viewpoints = bad}), rbpa::InvalidInput);
  std::vector<Point3> normals(2, {0, 0, 1});
  CHECK_THROWS_AS(rbpa::turn_toward(points, two, normals), rbpa::InvalidInput);
  normals.push_back({0, 0, 1});
  CHECK_THROWS_AS(rbpa::turn_toward(points, {}, normals), rbpa::InvalidInput);
}

TEST_SUITE_END();

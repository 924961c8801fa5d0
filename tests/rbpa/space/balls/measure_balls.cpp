#include "rbpa/space/balls/measure_balls.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/space/balls/union_of_balls.h"
#include "support/data_folder.h"
#include "support/random.h"
#include "support/solid_sets.h"
#include "support/vectors.h"

using namespace rbpa_test;
using rbpa::BallMeasures;
using rbpa::measure_balls;
using rbpa::Point3;
using std::numbers::pi;

TEST_SUITE_BEGIN("space");

namespace {

using doctest::Approx;
using Radii = std::vector<double>;

struct Balls {
  Points3 centers;
  Radii radii;
};

Balls random_balls(std::size_t count, double least, double greatest, std::uint64_t seed) {
  Random random(seed);
  Balls balls;
  for (std::size_t i = 0; i < count; ++i) {
    balls.centers.push_back({random.unit(), random.unit(), random.unit()});
    balls.radii.push_back(random.between(least, greatest));
  }
  return balls;
}

double square(const Point3& p, const Point3& q) {
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z);
}

/// Returns a random point at this distance from the center.
Point3 around(const Point3& center, double distance, Random& random) {
  const double z = random.between(-1, 1), angle = random.between(-pi, pi), r = distance * std::sqrt(1 - z * z);
  return {center.x + r * std::cos(angle), center.y + r * std::sin(angle), center.z + distance * z};
}

/// Compares each ball's share with random points in it and on its sphere. Deviations in standard errors must not exceed
/// five for any of them, and three for the sums; their squares must be about 1.
void check_by_random_points(const Balls& balls, int samples, std::uint64_t seed) {
  const auto& centers = balls.centers;
  const auto& radii = balls.radii;
  const BallMeasures found = measure_balls(centers, radii);
  Random random(seed);
  struct Sum {
    double found = 0, expected = 0, variance = 0;
  } total[2];
  double squares = 0;
  int counted = 0;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    std::vector<std::size_t> near;
    for (std::size_t j = 0; j < centers.size(); ++j)
      if (j != i && square(centers[i], centers[j]) <= (radii[i] + radii[j]) * (radii[i] + radii[j])) near.push_back(j);
    const auto has_least_power = [&](const Point3& p) {
      const double power = square(p, centers[i]) - radii[i] * radii[i];
      return std::all_of(near.begin(), near.end(), [&](std::size_t j) {
        const double other = square(p, centers[j]) - radii[j] * radii[j];
        return power < other || (power == other && i < j);
      });
    };
    for (const bool is_area : {false, true}) {
      int inside = 0;
      for (int sample = 0; sample < samples; ++sample)
        inside += has_least_power(around(centers[i], radii[i] * (is_area ? 1 : std::cbrt(random.unit())), random));
      const double whole = (is_area ? 4 : 4 * radii[i] / 3) * pi * radii[i] * radii[i];
      const double p = static_cast<double>(inside) / samples, share = is_area ? found.areas[i] : found.volumes[i];
      // At least that of one point, so that shares too small for any are within it.
      const double variance = std::max(p * (1 - p), 1.0 / samples) / samples * whole * whole;
      CAPTURE(i);
      CAPTURE(is_area);
      CHECK(std::abs(share - p * whole) <= 5 * std::sqrt(variance));
      if (inside > 20 && inside < samples - 20) {
        squares += (share - p * whole) * (share - p * whole) / variance;
        ++counted;
      }
      Sum& sum = total[is_area ? 1 : 0];
      sum.found += share;
      sum.expected += p * whole;
      sum.variance += variance;
    }
  }
  for (const Sum& sum : total) CHECK(std::abs(sum.found - sum.expected) <= 3 * std::sqrt(sum.variance));
  CHECK(std::abs(squares - counted) <= 4 * std::sqrt(2.0 * counted));
  CHECK(found.volume == Approx(total[0].found).epsilon(1e-12));
  CHECK(found.area == Approx(total[1].found).epsilon(1e-12));
}

double cap_volume(double radius, double height) { return pi * height * height * (radius - height / 3); }

/// Checks the balls of a chain along a line, in which only neighbors meet, by formulas.
void check_chain(const Radii& radii, const Radii& distances, const Point3& direction) {
  Points3 centers;
  double at = 0;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    centers.push_back({at * direction.x, at * direction.y, at * direction.z});
    if (i < distances.size()) at += distances[i];
  }
  const BallMeasures found = measure_balls(centers, radii, {.contacts = true, .derivatives = true});
  double volume = 0, area = 0;
  std::vector<double> volumes, areas;
  for (const double r : radii) {
    volumes.push_back(4 * pi / 3 * r * r * r);
    areas.push_back(4 * pi * r * r);
  }
  std::size_t contacts = 0;
  std::vector<std::uint32_t> arcs(radii.size(), 0);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const double d = distances[i], r = radii[i], s = radii[i + 1];
    if (d > r + s) continue;
    ++arcs[i];  // a whole circle
    ++arcs[i + 1];
    const double h = (d * d + r * r - s * s) / (2 * d), disc = pi * (r * r - h * h);
    volumes[i] -= cap_volume(r, r - h);
    volumes[i + 1] -= cap_volume(s, s - (d - h));
    areas[i] -= 2 * pi * r * (r - h);
    areas[i + 1] -= 2 * pi * s * (s - (d - h));
    REQUIRE(contacts < found.contacts.size());
    const rbpa::BallContact& contact = found.contacts[contacts++];
    CHECK(contact.balls == std::array{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1)});
    CHECK(contact.area == Approx(disc).epsilon(1e-13));
    CHECK(contact.arc == Approx(2 * std::sqrt(pi * disc)).epsilon(1e-7));
    CHECK(contact.distance == Approx(d).epsilon(1e-14));
  }
  CHECK(found.contacts.size() == contacts);
  CHECK(found.arcs == arcs);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    CHECK(found.volumes[i] == Approx(volumes[i]).epsilon(1e-13));
    CHECK(found.areas[i] == Approx(areas[i]).epsilon(1e-13));
    volume += volumes[i];
    area += areas[i];
  }
  CHECK(found.volume == Approx(volume).epsilon(1e-13));
  CHECK(found.area == Approx(area).epsilon(1e-13));
  CHECK(found.hidden.empty());
}

/// The arcs of the circle of two spheres that are in no other ball: their number, and the sum of their angles.
struct FreeArcs {
  std::uint32_t count = 0;
  double angle = 0;
};

FreeArcs free_arcs(const Balls& balls, std::size_t i, std::size_t j) {
  const auto& [centers, radii] = balls;
  const double d = std::sqrt(square(centers[i], centers[j])), r = radii[i], s = radii[j];
  const double height = (d * d + r * r - s * s) / (2 * d), size = r * r - height * height;
  if (!(size > 0)) return {};
  const Point3 axis = unit(centers[j] - centers[i]),
               across = unit(cross(axis, std::abs(axis.x) < 0.5 ? Point3{1, 0, 0} : Point3{0, 1, 0})),
               third = cross(axis, across);
  std::vector<std::pair<double, double>> covered;
  for (std::size_t k = 0; k < centers.size(); ++k) {
    if (k == i || k == j) continue;
    // At angle t the power to ball k is base − u cos t − v sin t.
    const Point3 to = centers[k] - centers[i] - height * axis;
    const double base = size + dot(to, to) - radii[k] * radii[k], u = 2 * std::sqrt(size) * dot(to, across),
                 v = 2 * std::sqrt(size) * dot(to, third), reach = std::hypot(u, v);
    if (base >= reach) continue;
    if (base <= -reach) return {};
    const double middle = std::atan2(v, u), half = std::acos(base / reach);
    for (const double turn : {-2 * pi, 0.0, 2 * pi})
      if (middle + half + turn > -pi && middle - half + turn < pi)
        covered.emplace_back(std::max(middle - half + turn, -pi), std::min(middle + half + turn, pi));
  }
  std::sort(covered.begin(), covered.end());
  FreeArcs result;
  double at = -pi;
  covered.emplace_back(pi, pi);
  for (const auto& [begin, end] : covered) {
    if (begin > at) {
      ++result.count;
      result.angle += begin - at;
    }
    at = std::max(at, end);
  }
  // An arc across the angle where the circle was cut counts twice.
  if (result.count > 1 && covered.front().first > -pi &&
      std::none_of(covered.begin(), covered.end() - 1, [](const auto& c) { return c.second == pi; }))
    --result.count;
  return result;
}

/// Returns the atoms of a .pdb file, without waters, with the radii of Bondi (1964).
Balls lysozyme() {
  const std::map<std::string, double> bondi = {{"C", 1.7}, {"N", 1.55}, {"O", 1.52}, {"S", 1.8}};
  std::ifstream file(bundled_data() / "mol3_2lyz.pdb");
  Balls balls;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("ATOM", 0) != 0) continue;
    const auto number = [&](std::size_t column) { return std::stod(line.substr(column, 8)); };
    balls.centers.push_back({number(30), number(38), number(46)});
    balls.radii.push_back(bondi.at(line.substr(13, 1)));
  }
  REQUIRE(balls.centers.size() == 1001);
  return balls;
}

}  // namespace

TEST_CASE("balls of a chain are measured as the formula of caps says: overlapping, apart, tangent, of radius 0") {
  for (const Point3& direction : {Point3{1, 0, 0}, Point3{0, 0.6, 0.8}, Point3{2.0 / 7, 3.0 / 7, 6.0 / 7}}) {
    check_chain({2}, {}, direction);
    check_chain({1, 1}, {1}, direction);
    check_chain({1, 0.5}, {0.75}, direction);    // the smaller center is beyond the plane of the circle
    check_chain({1, 0.25}, {0.875}, direction);  // and so is it here
    check_chain({1, 1}, {2.5}, direction);
    check_chain({1, 2, 1, 0.5, 3}, {2.5, 2.25, 1.25, 3.125}, direction);
    check_chain({1, 0, 1}, {1.5, 1.5}, direction);
    check_chain({0, 0}, {1}, direction);
  }
  check_chain({1, 0.5}, {1.5}, {1, 0, 0});  // tangent
  check_chain({0.5, 0}, {0.5}, {1, 0, 0});
}

TEST_CASE("balls within others, and equal ones, are hidden") {
  const double whole = 4 * pi / 3;
  const Points3 nested = {{0, 0, 0}, {0.25, 0, 0}, {0.25, 0, 0}, {0, 0, 0}, {3, 0, 0}, {3, 0, 0}};
  const BallMeasures found = measure_balls(nested, Radii{1, 0.5, 0.25, 0, 0.125, 0.125});
  CHECK(found.hidden == std::vector<std::uint32_t>{1, 2, 3, 5});
  CHECK(found.volume == Approx(whole * (1 + 1.0 / 512)).epsilon(1e-14));
  CHECK(found.areas == std::vector<double>{4 * pi, 0, 0, 0, pi / 16, 0});
  // Tangent from within: an edge of the complex, of area 0.
  const BallMeasures tangent = measure_balls(Points3{{0, 0, 0}, {0.5, 0, 0}}, Radii{1, 0.5});
  CHECK(tangent.volume == Approx(whole).epsilon(1e-14));
  CHECK(tangent.area == Approx(4 * pi).epsilon(1e-14));
  CHECK(measure_balls(Points3{}, Radii{}).volume == 0);
  const BallMeasures around = measure_balls(
      Points3{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {-4, -4, -4}, {0.5, 0.5, 0}}, Radii{1, 1, 1, 1, 1, 0.25});
  CHECK(around.hidden == std::vector<std::uint32_t>{5});
  CHECK(around.volume == Approx(5 * whole).epsilon(1e-14));
}

TEST_CASE("spheres may touch where a third one passes: their circle has no direction") {
  // From within: the second ball adds nothing.
  const BallMeasures two = measure_balls(Points3{{0, 2, 3}, {3, 2, 1}}, Radii{2, 3}),
                     three = measure_balls(Points3{{0, 2, 3}, {3, 2, 1}, {0, 2, 2}}, Radii{2, 3, 1});
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(three.volumes[i] == Approx(two.volumes[i]).epsilon(1e-14));
    CHECK(three.areas[i] == Approx(two.areas[i]).epsilon(1e-14));
  }
  CHECK(three.areas[2] == 0);
  // From outside: two balls, and a third through the point where they touch.
  const Points3 row = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}};
  const BallMeasures found = measure_balls(row, Radii{1, 1, 1}), near = measure_balls(row, Radii{1, 1, 1 - 1e-9});
  const double lens = 2 * cap_volume(1, 1 - std::sqrt(0.5));
  CHECK(found.volume == Approx(4 * pi - 2 * lens).epsilon(1e-14));
  for (std::size_t i = 0; i < 3; ++i) CHECK(found.areas[i] == Approx(near.areas[i]).epsilon(1e-7));
}

TEST_CASE("a ball however small on the circle of two large ones changes only its own share, from whichever end") {
  Random random(21);
  for (const double size : {1e-2, 1e-3, 1e-5, 1e-7, 1e-8, 1e-10, 1e-13, 1e-17})
    for (int trial = 0; trial < 20; ++trial) {
      CAPTURE(size);
      Balls balls = {{around({0, 0, 0}, 0.5, random), around({1, 2, 0}, 0.5, random)}, {2.5, 3}};
      const double d = std::sqrt(square(balls.centers[0], balls.centers[1])), height = (d * d + 6.25 - 9) / (2 * d);
      const Point3 axis = unit(balls.centers[1] - balls.centers[0]), across = unit(cross(axis, around({}, 1, random)));
      const BallMeasures two = measure_balls(balls.centers, balls.radii);
      balls.centers.push_back(balls.centers[0] + height * axis + std::sqrt(6.25 - height * height) * across +
                              around({}, size / 2, random));
      balls.radii.push_back(size);
      const BallMeasures three = measure_balls(balls.centers, balls.radii);
      std::swap(balls.centers[0], balls.centers[2]);
      std::swap(balls.radii[0], balls.radii[2]);
      const BallMeasures turned = measure_balls(balls.centers, balls.radii);
      CHECK(std::abs(three.areas[2] - turned.areas[0]) <= 1e-11 * size * size);
      CHECK(std::abs(three.volumes[2] - turned.volumes[0]) <= 1e-11 * size * size * size);
      for (std::size_t i = 0; i < 2; ++i) {
        CHECK(std::abs(three.areas[i] - two.areas[i]) <= 1e-12 + 20 * size * size);
        CHECK(std::abs(three.areas[i] - turned.areas[i == 0 ? 2 : 1]) <= 1e-12);
      }
    }
}

TEST_CASE("each ball's volume and area agree with random points: few balls, of any arrangement") {
  const Points3 acute = {{0, 0, 0}, {1, 0, 0}, {0.4, 0.9, 0.3}}, obtuse = {{0, 0, 0}, {1, 0, 0}, {0.4, 0.2, 0.1}},
                line = {{0, 0, 0}, {0.7, 0.1, 0.2}, {1.4, 0.2, 0.4}},
                four = {{0, 0, 0}, {1, 0, 0}, {0.4, 0.9, 0.3}, {0.5, 0.2, 0.8}},
                sliver = {{0, 0, 0}, {1, 0, 0}, {1, 1, 1e-9}, {0, 1, 0}},
                square = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  std::uint64_t seed = 0;
  for (const Points3& centers : {acute, obtuse, line, four, sliver, square})
    for (const double radius : {0.3, 0.56, 0.6, 0.71, 0.9, 2.0})
      for (const double other : {0.0, 0.1, 0.25}) {
        CAPTURE(radius);
        CAPTURE(other);
        Radii radii(centers.size(), radius);
        radii[0] += other;
        radii[1] -= other;
        check_by_random_points({centers, radii}, 20000, ++seed);
      }
}

TEST_CASE("each ball's volume and area agree with random points: random balls, also within others and of radius 0") {
  std::uint64_t seed = 100;
  for (const std::size_t count : {5U, 12U, 40U, 150U})
    for (const auto& [least, greatest] : {std::pair{0.05, 0.15}, {0.1, 0.3}, {0.0, 0.6}, {0.3, 0.35}, {0.0, 0.1}}) {
      const Balls balls = random_balls(count, least, greatest, ++seed);
      check_by_random_points(balls, 2000, seed);
    }
}

TEST_CASE("each atom's volume and area agree with random points, without and with a probe") {
  Balls atoms = lysozyme();
  check_by_random_points(atoms, 2000, 7);
  const BallMeasures by_probe = measure_balls(atoms.centers, atoms.radii, {.probe = 1.4});
  for (double& radius : atoms.radii) radius += 1.4;
  check_by_random_points(atoms, 2000, 8);
  const BallMeasures found = measure_balls(atoms.centers, atoms.radii);
  CHECK(found.areas == by_probe.areas);
  CHECK(found.volume == by_probe.volume);
}

TEST_CASE("a ball's arcs are those of its circles that no other ball covers") {
  for (const auto& [least, greatest] : {std::pair{0.05, 0.15}, {0.1, 0.3}, {0.0, 0.4}, {0.3, 0.35}}) {
    const Balls balls = random_balls(120, least, greatest, 30);
    const BallMeasures found = measure_balls(balls.centers, balls.radii, {.contacts = true});
    std::vector<std::uint32_t> arcs(balls.radii.size(), 0);
    std::map<std::array<std::uint32_t, 2>, double> lengths;
    for (std::uint32_t i = 0; i < balls.radii.size(); ++i)
      for (std::uint32_t j = i + 1; j < balls.radii.size(); ++j) {
        const FreeArcs free = free_arcs(balls, i, j);
        arcs[i] += free.count;
        arcs[j] += free.count;
        if (free.count > 0) lengths[{i, j}] = free.angle;
      }
    CHECK(found.arcs == arcs);
    CHECK(*std::max_element(arcs.begin(), arcs.end()) > 5);
    std::size_t exposed = 0;
    for (const rbpa::BallContact& contact : found.contacts) {
      if (contact.arc == 0) continue;
      ++exposed;
      const double d = contact.distance, r = balls.radii[contact.balls[0]], s = balls.radii[contact.balls[1]],
                   height = (d * d + r * r - s * s) / (2 * d);
      CHECK(contact.arc == Approx(lengths.at(contact.balls) * std::sqrt(r * r - height * height)).epsilon(1e-9));
    }
    CHECK(exposed == lengths.size());
  }
}

TEST_CASE("equal radii give what union_of_balls() gives") {
  for (const SolidSet& set : solid_sets(300)) {
    CAPTURE(set.name);
    const auto [low, high] = std::minmax_element(set.points.begin(), set.points.end());
    const double size = std::sqrt(square(*low, *high));
    for (const double part : {0.01, 0.05, 0.1, 0.3, 2.0}) {
      CAPTURE(part);
      const double radius = part * size;
      const rbpa::BallUnion expected = rbpa::union_of_balls(set.points, radius);
      const BallMeasures found = measure_balls(set.points, Radii(set.points.size(), radius));
      CHECK(found.volume == expected.volume);
      CHECK(found.area == expected.area);
    }
  }
}

TEST_CASE("on a grid contacts are the faces of cubes") {
  const Points3 centers = rbpa_test::corners_of_bricks(3, 3, 3);
  const BallMeasures found = measure_balls(centers, Radii(27, 1), {.contacts = true});
  std::vector<double> of_middle;
  for (const rbpa::BallContact& contact : found.contacts)
    if (contact.balls[0] == 13 || contact.balls[1] == 13) {
      CHECK(contact.arc == 0);
      if (contact.distance == 1)
        of_middle.push_back(contact.area);
      else
        CHECK(contact.area == Approx(0).epsilon(1e-14));
    }
  REQUIRE(of_middle.size() == 6);
  for (const double area : of_middle) CHECK(area == Approx(1).epsilon(1e-14));
  CHECK(found.volumes[13] == Approx(1).epsilon(1e-14));
  CHECK(found.areas[13] == 0);
}

TEST_CASE("gradients agree with central differences, and vanish for translations") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Balls balls = random_balls(30, 0.1, 0.4, seed);
    const BallMeasures found = measure_balls(balls.centers, balls.radii, {.derivatives = true});
    Point3 sums[2] = {};
    for (std::size_t i = 0; i < balls.centers.size(); ++i)
      for (double Point3::*axis : {&Point3::x, &Point3::y, &Point3::z}) {
        const double step = 1e-6;
        Points3 moved[2] = {balls.centers, balls.centers};
        moved[0][i].*axis -= step;
        moved[1][i].*axis += step;
        const BallMeasures before = measure_balls(moved[0], balls.radii), after = measure_balls(moved[1], balls.radii);
        CHECK(found.volume_gradient[i].*axis == Approx((after.volume - before.volume) / (2 * step)).epsilon(1e-6));
        CHECK(std::abs(found.area_gradient[i].*axis - (after.area - before.area) / (2 * step)) < 2e-8);
        sums[0].*axis += found.volume_gradient[i].*axis;
        sums[1].*axis += found.area_gradient[i].*axis;
      }
    for (const Point3& sum : sums) CHECK(std::abs(sum.x) + std::abs(sum.y) + std::abs(sum.z) < 1e-12);
  }
}

TEST_CASE("threads do not change a bit; scaling, moving and the order of balls change only the rounding") {
  Balls balls{jittered_cubes(12'000, 5), {}};
  Random random(6);
  for (std::size_t i = 0; i < balls.centers.size(); ++i) balls.radii.push_back(random.between(0.4, 1));
  const rbpa::MeasureBallsOptions all = {.contacts = true, .derivatives = true, .threads = 1};
  rbpa::MeasureBallsOptions by_three = all;
  by_three.threads = 3;
  const BallMeasures expected = measure_balls(balls.centers, balls.radii, all),
                     threaded = measure_balls(balls.centers, balls.radii, by_three);
  CHECK(threaded.volume == expected.volume);
  CHECK(threaded.areas == expected.areas);
  CHECK(threaded.volumes == expected.volumes);
  CHECK(threaded.volume_gradient == expected.volume_gradient);
  CHECK(threaded.area_gradient == expected.area_gradient);
  CHECK(threaded.arcs == expected.arcs);
  CHECK(measure_balls(balls.centers, balls.radii).areas == expected.areas);  // whatever else is computed
  CHECK(std::equal(
      threaded.contacts.begin(), threaded.contacts.end(), expected.contacts.begin(), expected.contacts.end(),
      [](const auto& a, const auto& b) { return a.balls == b.balls && a.area == b.area && a.arc == b.arc; }));
  balls.centers.resize(400);
  balls.radii.resize(400);
  const BallMeasures few = measure_balls(balls.centers, balls.radii, all);
  const std::size_t last = balls.centers.size() - 1;
  for (const double scale : {0x1p-300, 1e-100, 1e100}) {
    Balls other;
    for (std::size_t i = 0; i <= last; ++i) {
      const Point3& p = balls.centers[last - i];
      other.centers.push_back({scale * p.x, scale * p.y, scale * p.z});
      other.radii.push_back(scale * balls.radii[last - i]);
    }
    const BallMeasures found = measure_balls(other.centers, other.radii, all);
    CHECK(found.volume / scale / scale / scale == Approx(few.volume).epsilon(1e-12));
    for (std::size_t i = 0; i <= last; ++i) {
      CHECK(found.areas[last - i] / scale / scale == Approx(few.areas[i]).epsilon(1e-10));
      CHECK(found.area_gradient[last - i].x / scale == Approx(few.area_gradient[i].x).epsilon(1e-10));
    }
  }
}

TEST_CASE("centers that nearly coincide have nearly one ball, however near they are") {
  for (const double size : {1e-3, 1e-9, 1e-100, 1e-160, 1e-200, 1e-300}) {
    CAPTURE(size);
    Points3 centers = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}, {size, size, size / 2}, {1, 0, 0}};
    const Radii radii = {1, 1, 1, 1 - size / 8, 1, 0.75};
    const BallMeasures two = measure_balls(Points3{{0, 0, 0}, {1, 0, 0}}, Radii{1, 0.75}),
                       found = measure_balls(centers, radii);
    CHECK(found.volume == Approx(two.volume).epsilon(4 * size + 1e-13));
    CHECK(found.area == Approx(two.area).epsilon(4 * size + 1e-13));
  }
}

TEST_CASE("radii over nine decades are measured") {
  Balls balls = random_balls(300, 0, 0, 11);
  Random random(12);
  for (double& radius : balls.radii) radius = std::pow(10, random.between(-9, 0)) / 2;
  check_by_random_points(balls, 1000, 13);
}

TEST_CASE("invalid balls are refused, and a run is cancelled on request") {
  const double infinity = std::numeric_limits<double>::infinity();
  const Points3 two = {{0, 0, 0}, {1, 0, 0}};
  CHECK_THROWS_AS(measure_balls(two, Radii{1}), rbpa::InvalidInput);
  CHECK_THROWS_AS(measure_balls(Points3{{0, 0, infinity}}, Radii{1}), rbpa::InvalidInput);
  for (const double radius : {-1.0, infinity, std::nan("")})
    CHECK_THROWS_AS(measure_balls(two, Radii{1, radius}), rbpa::InvalidInput);
  CHECK_THROWS_AS(measure_balls(two, Radii{1, 1}, {.probe = -1.5}), rbpa::InvalidInput);
  CHECK(measure_balls(two, Radii{1, 1.5}, {.probe = -1}).areas[0] == 0);
  CHECK_THROWS_AS(measure_balls(Points3{{1e308, 0, 0}, {-1e308, 0, 0}}, Radii{1, 1}), rbpa::InvalidInput);
  CHECK_THROWS_AS(measure_balls(two, Radii{1, 1}, rbpa::RegularTriangulation{}), meshops::ContractViolation);
  const Balls many = random_balls(2000, 0.01, 0.1, 3);
  CHECK_THROWS_AS(measure_balls(many.centers, many.radii, {.progress = [](const rbpa::Progress&) { return false; }}),
                  rbpa::Cancelled);
}

TEST_SUITE_END();

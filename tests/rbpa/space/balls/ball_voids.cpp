#include "rbpa/space/balls/ball_voids.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/space/balls/full_topology.h"
#include "rbpa/space/balls/measure_balls.h"
#include "rbpa/space/solid/solid_radii.h"
#include "space/balls/hollow_balls.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using std::numbers::pi;

TEST_SUITE_BEGIN("space");

namespace {

using doctest::Approx;

/// Returns the radius of the largest ball that touches four lining balls, meets none of any, and has its center in the
/// void: by trying all quadruples.
double largest_by_trial(const Balls& balls, const BallVoid& of, const RegularTriangulation& regular) {
  double best = 0;
  const std::size_t n = of.balls.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      for (std::size_t k = j + 1; k < n; ++k)
        for (std::size_t l = k + 1; l < n; ++l) {
          const std::array<std::uint32_t, 4> b = {of.balls[i].ball, of.balls[j].ball, of.balls[k].ball,
                                                  of.balls[l].ball};
          const Point3& origin = balls.centers[b[0]];
          const double r0 = balls.radii[b[0]];
          std::array<Point3, 3> u;
          std::array<double, 3> constant{}, slope{};
          for (std::size_t m = 0; m < 3; ++m) {
            u[m] = minus(balls.centers[b[m + 1]], origin);
            const double r = balls.radii[b[m + 1]];
            constant[m] = (u[m].x * u[m].x + u[m].y * u[m].y + u[m].z * u[m].z + r0 * r0 - r * r) / 2;
            slope[m] = r0 - r;
          }
          const double volume = det(u[0], u[1], u[2]);
          if (std::abs(volume) < 1e-9) continue;
          const auto solve = [&](const std::array<double, 3>& right) {
            const auto column = [&](double Point3::*axis) {
              std::array<Point3, 3> m = u;
              for (std::size_t r = 0; r < 3; ++r) m[r].*axis = right[r];
              return det(m[0], m[1], m[2]) / volume;
            };
            return Point3{column(&Point3::x), column(&Point3::y), column(&Point3::z)};
          };
          const Point3 p = solve(constant), q = solve(slope);
          const double a = q.x * q.x + q.y * q.y + q.z * q.z - 1, c = p.x * p.x + p.y * p.y + p.z * p.z - r0 * r0,
                       half = p.x * q.x + p.y * q.y + p.z * q.z - r0, root = std::sqrt(half * half - a * c);
          for (const double s : {(-half + root) / a, (-half - root) / a}) {
            const Point3 x = plus(plus(origin, 1, p), s, q);
            if (s > best && clearance(balls, x) > s - 1e-9 && is_in(x, balls, of, regular)) best = s;
          }
        }
  return best;
}

/// Returns the same for any order of balls: corners by coordinates.
auto by_coordinates(const Balls& balls, const RegularTriangulation& regular, const std::vector<BallVoid>& all) {
  std::vector<std::pair<std::set<std::vector<Point3>>, std::vector<std::set<std::vector<Point3>>>>> result;
  const auto points = [&](const auto& simplex) {
    std::vector<Point3> corners;
    for (const std::uint32_t i : simplex) corners.push_back(balls.centers[i]);
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  for (const BallVoid& of : all) {
    auto& [tetrahedra, mouths] = result.emplace_back();
    for (const std::uint32_t t : of.tetrahedra) tetrahedra.insert(points(regular.simplices[t]));
    for (const BallMouth& mouth : of.mouths) {
      mouths.emplace_back();
      for (const rbpa::Triangle& triangle : mouth.triangles) mouths.back().insert(points(triangle));
    }
  }
  return result;
}

Balls box(std::initializer_list<double> radius_by_height) {
  Balls balls;
  double z = 0;
  for (const double radius : radius_by_height) {
    for (const double x : {0.0, 1.0})
      for (const double y : {0.0, 1.0}) {
        balls.centers.push_back({x, y, z});
        balls.radii.push_back(radius);
      }
    ++z;
  }
  return balls;
}

}  // namespace

TEST_CASE("the void between four balls has the volume and area of the formula") {
  const Points3 centers = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const double edge = std::sqrt(8.0), whole = edge * edge * edge / (6 * std::sqrt(2.0));
  for (const double r : {1.64, 1.7, 1.73}) {  // faces close at 1.633; the void fills at 1.732
    const BallVoids found = find_voids({centers, std::vector<double>(4, r)});
    REQUIRE(found.voids.size() == 1);
    CHECK(found.pockets.empty());
    const BallVoid& hollow = found.voids[0];
    const auto sizes = [&](std::size_t count) {
      const auto of = rbpa::measure_balls(std::span(centers).first(count), std::vector<double>(count, r));
      return std::array{of.volume, of.area};
    };
    const std::array<double, 2> one = sizes(1), two = sizes(2), three = sizes(3);
    std::array<double, 2> left = {whole, 0};
    for (std::size_t k = 0; k < 2; ++k) {
      const double lens = 2 * one[k] - two[k], common = three[k] - 3 * two[k] + 3 * one[k];
      const double inside = std::acos(23.0 / 27) / pi * one[k] - 3 * std::acos(1.0 / 3) / pi * lens + 2 * common;
      left[k] = k == 0 ? whole - inside : inside;
    }
    CHECK(hollow.volume_of_tetrahedra == Approx(whole).epsilon(1e-14));
    CHECK(std::abs(hollow.volume - left[0]) <= 1e-12);
    CHECK(std::abs(hollow.area - left[1]) <= 1e-12);
    CHECK(found.volume == hollow.volume);
    CHECK(hollow.power == Approx(3 - r * r).epsilon(1e-12));
    CHECK(hollow.radius == Approx(std::sqrt(3.0) - r).epsilon(1e-10));
    CHECK(distance(hollow.center, {}) < 1e-14);
    REQUIRE(hollow.balls.size() == 4);
    for (const rbpa::LiningBall& ball : hollow.balls) CHECK(ball.area == Approx(left[1] / 4).epsilon(1e-10));
  }
  CHECK(find_voids({centers, std::vector<double>(4, 1.74)}).voids.empty());
}

TEST_CASE("an open box is a pocket whose mouth has the sizes of the formula") {
  const double r = 0.65, wide = 0.85;
  const Balls balls = box({wide, r});
  const BallVoids found = find_voids(balls);
  CHECK(found.voids.empty());
  REQUIRE(found.pockets.size() == 1);
  const BallVoid& pocket = found.pockets[0];
  CHECK(pocket.volume_of_tetrahedra == Approx(1).epsilon(1e-14));
  CHECK(pocket.power == Approx(0.5 + 0.65 * 0.65 - wide * wide).epsilon(1e-12));
  double low = 0.5, high = 1;  // the height at which both layers are equally near
  for (int i = 0; i < 60; ++i) {
    const double z = (low + high) / 2;
    (std::sqrt(0.5 + z * z) - wide < std::sqrt(0.5 + (1 - z) * (1 - z)) - r ? low : high) = z;
  }
  CHECK(distance(pocket.center, {0.5, 0.5, low}) < 1e-12);
  CHECK(pocket.radius == Approx(std::sqrt(0.5 + low * low) - wide).epsilon(1e-12));
  REQUIRE(pocket.mouths.size() == 1);
  const BallMouth& mouth = pocket.mouths[0];
  CHECK(mouth.triangles.size() == 2);
  CHECK(mouth.balls == std::vector<std::uint32_t>{4, 5, 6, 7});
  const double angle = std::acos(0.5 / r), lens = 2 * r * r * angle - 0.5 * std::sqrt(4 * r * r - 1);
  CHECK(mouth.area_of_triangles == Approx(1).epsilon(1e-14));
  CHECK(mouth.area == Approx(1 - pi * r * r + 2 * lens).epsilon(1e-12));
  CHECK(mouth.perimeter == Approx(4 * r * (pi / 2 - 2 * angle)).epsilon(1e-12));
  CHECK(mouth.power == Approx(0.5 - r * r).epsilon(1e-12));
  CHECK(mouth.radius == Approx(std::sqrt(0.5) - r).epsilon(1e-12));
  CHECK(distance(mouth.center, {0.5, 0.5, 1}) < 1e-14);
  // Above the power of the mouth it is a void, above that of the pocket nothing.
  const auto grown = [&](double power) {
    Balls wider = balls;
    for (double& radius : wider.radii) radius = std::sqrt(radius * radius + power);
    return find_voids(wider);
  };
  CHECK(grown(mouth.power - 1e-9).pockets.size() == 1);
  CHECK(grown(mouth.power + 1e-9).voids.size() == 1);
  CHECK(grown(pocket.power - 1e-9).voids.size() == 1);
  CHECK(grown(pocket.power + 1e-9).voids.empty());
}

TEST_CASE("two chambers with a window are one void, and two where the window is closed") {
  const BallVoids open = find_voids(box({0.85, 0.65, 0.85}));
  REQUIRE(open.voids.size() == 1);
  CHECK(open.pockets.empty());
  const BallVoids closed = find_voids(box({0.85, 0.7072, 0.85}));
  REQUIRE(closed.voids.size() == 2);
  CHECK(closed.voids[0].volume == Approx(closed.voids[1].volume).epsilon(1e-10));
  CHECK(closed.voids[0].center.z == Approx(2 - closed.voids[1].center.z).epsilon(1e-9));
}

TEST_CASE("equal radii give the voids of the full alpha complex") {
  std::size_t voids = 0;
  for (const SolidSet& set : solid_sets(150)) {
    CAPTURE(set.name);
    const rbpa::Solid delaunay = rbpa::solid(set.points, std::numeric_limits<double>::infinity());
    if (delaunay.simplices.empty()) continue;
    const std::vector<double> radii = rbpa::circumradii(set.points, delaunay.simplices);
    std::vector<double> alphas = radii;
    std::sort(alphas.begin(), alphas.end());
    for (const std::size_t part : {3U, 5U, 7U, 9U}) {
      const double alpha = alphas[alphas.size() * part / 10];
      const rbpa::FullVoids expected =
          rbpa::full_voids(set.points, rbpa::void_space(set.points, delaunay, radii, alpha), alpha);
      const BallVoids found = find_voids({set.points, std::vector<double>(set.points.size(), alpha)}, false);
      REQUIRE(found.voids.size() == expected.all.size());
      voids += found.voids.size();
      for (std::size_t i = 0; i < found.voids.size(); ++i) {
        CHECK(found.voids[i].volume_of_tetrahedra == Approx(expected.all[i].volume).epsilon(1e-9));
        CHECK(found.voids[i].volume == Approx(*expected.all[i].outside_balls).epsilon(1e-9));
        if (std::isfinite(alpha) && set.name != "clusters")
          CHECK(std::sqrt(alpha * alpha + found.voids[i].power) - alpha == Approx(found.voids[i].radius).epsilon(1e-6));
      }
    }
  }
  CHECK(voids > 40);
}

TEST_CASE("the boundary of a void or pocket is closed, counter-clockwise from outside, and encloses its tetrahedra") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Balls balls = shell(150, 20, 0.12, 0.3, 0.1, 4000 + seed);
    const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
    const BallVoids found = find_voids(balls);
    for (const std::vector<BallVoid>& list : {found.voids, found.pockets})
      for (const BallVoid& hollow : list) {
        double volume = 0;
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> turns;
        for (const rbpa::Triangle& triangle : boundary_of(hollow, regular)) {
          for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
            turns[std::minmax(a, b)] += a < b ? 1 : -1;
          }
          volume += det(balls.centers[triangle[0]], balls.centers[triangle[1]], balls.centers[triangle[2]]) / 6;
        }
        CHECK(std::all_of(turns.begin(), turns.end(), [](const auto& edge) { return edge.second == 0; }));
        CHECK(volume == Approx(hollow.volume_of_tetrahedra).epsilon(1e-12));
      }
  }
}

TEST_CASE("the largest ball of a void touches four balls, and no quadruple has a larger one") {
  std::size_t voids = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    CAPTURE(seed);
    const Balls balls = shell(40, static_cast<int>(seed % 2 * 3), 0.42, 0.6, 0, seed);
    const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
    for (const BallVoid& of : ball_voids(balls.centers, balls.radii, regular, {}).voids) {
      ++voids;
      CHECK(of.radius > 0);
      CHECK(clearance(balls, of.center) == Approx(of.radius).epsilon(1e-12));
      CHECK(is_in(of.center, balls, of, regular));
      CHECK(of.radius == Approx(largest_by_trial(balls, of, regular)).epsilon(1e-8));
    }
  }
  CHECK(voids >= 8);
}

TEST_CASE("the order of balls, threads and scales do not matter") {
  Random random(9);
  const Balls balls = lysozyme(0.7);
  const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
  const BallVoids expected = ball_voids(balls.centers, balls.radii, regular, {.pockets = true});
  CHECK(expected.voids.size() + expected.pockets.size() > 20);
  std::vector<std::size_t> order(balls.radii.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  for (const double scale : {1.0, 0x1p-300, 1e100}) {
    random.shuffle(order);
    Balls other, same;
    for (const std::size_t i : order) {
      other.centers.push_back(plus({}, scale, balls.centers[i]));
      other.radii.push_back(scale * balls.radii[i]);
      same.centers.push_back(balls.centers[i]);
    }
    const RegularTriangulation theirs = rbpa::regular_triangulation(other.centers, other.radii);
    const BallVoids found = ball_voids(other.centers, other.radii, theirs, {.pockets = true, .threads = 2});
    CHECK(by_coordinates(same, theirs, found.voids) == by_coordinates(balls, regular, expected.voids));
    CHECK(by_coordinates(same, theirs, found.pockets) == by_coordinates(balls, regular, expected.pockets));
    for (const auto& [all, of] : {std::pair(&found.voids, &expected.voids), {&found.pockets, &expected.pockets}})
      for (std::size_t i = 0; i < all->size(); ++i) {
        const BallVoid &a = (*all)[i], &b = (*of)[i];
        CHECK(std::abs(a.volume / scale / scale / scale - b.volume) < 1e-9);
        CHECK(std::abs(a.area / scale / scale - b.area) < 1e-9);
        CHECK(a.radius / scale == Approx(b.radius).epsilon(1e-10));
        for (std::size_t k = 0; k < a.mouths.size(); ++k) {
          CHECK(std::abs(a.mouths[k].area / scale / scale - b.mouths[k].area) < 1e-9);
          CHECK(std::abs(a.mouths[k].perimeter / scale - b.mouths[k].perimeter) < 1e-6);
          CHECK(a.mouths[k].radius / scale == Approx(b.mouths[k].radius).epsilon(1e-10));
        }
      }
  }
}

TEST_CASE("balls of every kind have voids and pockets with sizes, which do not depend on their order") {
  Random random(11);
  std::size_t regions = 0;
  for (int set = 0; set < 2 * space_kinds * radius_kinds; ++set) {
    Balls balls = ball_set(static_cast<SpaceKind>(set % space_kinds),
                           static_cast<RadiusKind>(set / space_kinds % radius_kinds), 30, random);
    CAPTURE(text(balls));
    const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
    const BallVoids found = ball_voids(balls.centers, balls.radii, regular, {.pockets = true});
    std::vector<std::size_t> order(balls.radii.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    random.shuffle(order);
    Balls other;
    for (const std::size_t i : order) {
      other.centers.push_back(balls.centers[i]);
      other.radii.push_back(balls.radii[i]);
    }
    const RegularTriangulation theirs = rbpa::regular_triangulation(other.centers, other.radii);
    const BallVoids again = ball_voids(other.centers, other.radii, theirs, {.pockets = true});
    CHECK(by_coordinates(other, theirs, again.voids) == by_coordinates(balls, regular, found.voids));
    CHECK(by_coordinates(other, theirs, again.pockets) == by_coordinates(balls, regular, found.pockets));
    for (const auto* all : {&found.voids, &found.pockets})
      for (const BallVoid& of : *all) {
        ++regions;
        CHECK(!std::isnan(of.volume));  // at 1e150 it is infinite
        CHECK(!std::isnan(of.area));
        CHECK(std::isfinite(of.radius));
        CHECK(of.radius >= 0);
        for (const BallMouth& mouth : of.mouths) {
          CHECK(std::isfinite(mouth.area));
          CHECK(mouth.area <= mouth.area_of_triangles);
          CHECK(std::isfinite(mouth.perimeter));
          CHECK(std::isfinite(mouth.radius));
        }
      }
  }
  CHECK(regions > 40);
}

TEST_CASE("balls in a plane have no voids, and invalid arguments are refused") {
  CHECK(find_voids({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {0.6, 0.6, 0.7, 0}}).voids.empty());
  CHECK(find_voids({{}, {}}).voids.empty());
  const Balls balls = box({0.85, 0.65});
  RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
  CHECK_THROWS_AS(ball_voids(balls.centers, std::vector<double>{1}, regular), meshops::ContractViolation);
  CHECK_THROWS_AS(ball_voids(std::span(balls.centers).first(7), std::span(balls.radii).first(7), regular),
                  meshops::ContractViolation);
  CHECK_THROWS_AS(
      ball_voids(balls.centers, balls.radii, regular, {.progress = [](const rbpa::Progress&) { return false; }}),
      rbpa::Cancelled);
  regular.neighbors.clear();
  CHECK_THROWS_AS(ball_voids(balls.centers, balls.radii, regular), meshops::ContractViolation);
}

TEST_SUITE_END();

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "rbpa/space/balls/full/faces_within.h"
#include "rbpa/space/balls/full/far_points.h"
#include "rbpa/space/balls/full/outside_of_balls.h"
#include "rbpa/space/balls/measure_balls.h"
#include "rbpa/space/predicate/orthosphere.h"
#include "rbpa/space/predicate/vector3.h"
#include "space/balls/hollow_balls.h"

using namespace rbpa_test;
using std::numbers::pi;

TEST_SUITE_BEGIN("space");

namespace {

using doctest::Approx;

/// Compares with random points: volume and area outside of the balls in each void, area and perimeter of each mouth.
/// Deviations in standard errors must not exceed five, and the sum of their squares must be about their number.
void check_by_random_points(const Balls& balls, int samples, std::uint64_t seed) {
  Random random(seed);
  const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
  const BallVoids found = ball_voids(balls.centers, balls.radii, regular, {.pockets = true});
  double squares = 0;
  int counted = 0;
  const auto check = [&](double share, double whole, int inside, int of) {
    const double p = static_cast<double>(inside) / of;
    const double variance = std::max(p * (1 - p), 1.0 / of) / of * whole * whole;
    CHECK(std::abs(share - p * whole) <= 5 * std::sqrt(variance));
    if (inside < 20 || of - inside < 20) return;
    squares += (share - p * whole) * (share - p * whole) / variance;
    ++counted;
  };
  for (const BallVoid& hollow : found.voids) {
    std::vector<double> up_to;
    double sum = 0, area = 0;
    for (const std::uint32_t t : hollow.tetrahedra) {
      const auto& row = regular.simplices[t];
      const auto to = [&](std::size_t k) { return minus(balls.centers[row[k]], balls.centers[row[0]]); };
      up_to.push_back(sum += det(to(1), to(2), to(3)) / 6);
    }
    CHECK(hollow.volume_of_tetrahedra == Approx(sum).epsilon(1e-12));
    int outside = 0;
    for (int i = 0; i < samples; ++i) {
      const auto at = std::upper_bound(up_to.begin(), up_to.end(), sum * random.unit()) - up_to.begin();
      std::array<double, 4> weight{};
      double all = 0;
      for (double& w : weight) all += w = -std::log(1 - random.unit());
      Point3 x;
      for (std::size_t k = 0; k < 4; ++k)
        x = plus(x, weight[k] / all,
                 balls.centers[regular.simplices[hollow.tetrahedra[static_cast<std::size_t>(at)]][k]]);
      outside += clearance(balls, x) > 0 ? 1 : 0;
    }
    check(hollow.volume, sum, outside, samples);
    for (const auto& [i, part] : hollow.balls) {
      const double r = balls.radii[i];
      int facing = 0;
      for (int sample = 0; sample < samples / 4; ++sample) {
        const Point3 x = plus(balls.centers[i], r, on_sphere(random));
        facing += clearance(balls, x, i) > 0 && is_in(x, balls, hollow, regular) ? 1 : 0;
      }
      check(part, 4 * pi * r * r, facing, samples / 4);
      area += part;
    }
    CHECK(hollow.area == Approx(area).epsilon(1e-12));
  }
  for (const BallVoid& pocket : found.pockets)
    for (const BallMouth& mouth : pocket.mouths) {
      double sum = 0, left = 0, variance = 0, length = 0, error = 0;
      for (const auto& [a, b, c] : mouth.triangles) {
        const Point3 p = balls.centers[a], u = minus(balls.centers[b], p), v = minus(balls.centers[c], p);
        const Point3 cross = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
        const double twice = distance(cross, {});
        int outside = 0;
        for (int sample = 0; sample < samples; ++sample) {
          double s = random.unit(), t = random.unit();
          if (s + t > 1) s = 1 - s, t = 1 - t;
          outside += clearance(balls, plus(plus(p, s, u), t, v)) > 0 ? 1 : 0;
        }
        const double share = static_cast<double>(outside) / samples;
        sum += twice / 2;
        left += share * twice / 2;
        variance += std::max(share * (1 - share), 1.0 / samples) / samples * twice * twice / 4;
        // The border: points of all circles in the plane, in the triangle and outside of other balls.
        const Point3 n = plus({}, 1 / twice, cross), e = plus({}, 1 / distance(u, {}), u);
        const Point3 f = {n.y * e.z - n.z * e.y, n.z * e.x - n.x * e.z, n.x * e.y - n.y * e.x};
        for (std::size_t i = 0; i < balls.radii.size(); ++i) {
          const Point3 to = minus(balls.centers[i], p);
          const double height = to.x * n.x + to.y * n.y + to.z * n.z;
          if (std::abs(height) >= balls.radii[i]) continue;
          const double radius = std::sqrt(balls.radii[i] * balls.radii[i] - height * height);
          const Point3 foot = plus(balls.centers[i], -height, n);
          int on = 0;
          for (int sample = 0; sample < samples; ++sample) {
            const double angle = 2 * pi * (sample + random.unit()) / samples;
            const Point3 x = plus(plus(foot, radius * std::cos(angle), e), radius * std::sin(angle), f),
                         q = minus(x, p);
            const double s = det(q, v, n) / det(u, v, n), t = det(u, q, n) / det(u, v, n);
            on += s >= 0 && t >= 0 && s + t <= 1 && clearance(balls, x, i) > 0 ? 1 : 0;
          }
          length += 2 * pi * radius * on / samples;
          error += 2 * pi * radius * 8 / samples;  // an arc's ends are seen to within a sample
        }
      }
      CHECK(mouth.area_of_triangles == Approx(sum).epsilon(1e-12));
      CHECK(std::abs(mouth.area - left) <= 5 * std::sqrt(variance));
      CHECK(std::abs(mouth.perimeter - length) <= error);
    }
  if (counted > 0) CHECK(std::abs(squares - counted) <= 5 * std::sqrt(2.0 * counted));
}

/// Checks that what the balls leave of all tetrahedra outside of the complex is what the union leaves, ball by ball, in
/// a triangulation with further points of radius 0 around all balls.
void check_sums(Balls balls) {
  const auto reach = *std::max_element(balls.radii.begin(), balls.radii.end());
  Point3 low = balls.centers[0], high = low;
  for (const Point3& p : balls.centers) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double size = 8 * (reach + high.x - low.x + high.y - low.y + high.z - low.z);
  for (const Point3& p : {Point3{low.x - size, low.y - size, low.z - size}, Point3{high.x + 4 * size, low.y, low.z},
                          Point3{low.x, high.y + 4 * size, low.z}, Point3{low.x, low.y, high.z + 4 * size}}) {
    balls.centers.push_back(p);
    balls.radii.push_back(0);
  }
  const RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
  const rbpa::space::Triangulated cells(balls.centers, regular);
  rbpa::Threads one(1);
  const rbpa::space::FacesWithin faces(cells, balls.radii, one);
  std::vector<std::uint32_t> region;
  double in_complex = 0, whole = 0;
  for (std::uint32_t t = 0; t < regular.simplices.size(); ++t) {
    const double volume = rbpa::space::volume<double>(balls.centers, regular.simplices[t]);
    in_complex += faces.has_tetrahedron(t) ? volume : 0;
    whole += volume;
    region.push_back(faces.has_tetrahedron(t) ? rbpa::space::BallRegions::none : t % 3);  // cut anywhere
  }
  std::vector<bool> is_end(balls.radii.size(), false);
  rbpa::space::for_each_edge(
      cells, rbpa::space::PointStars(cells), one,
      [&](std::uint32_t, std::uint32_t, std::span<const rbpa::space::EdgeAt> ring) { return faces.has_edge(ring); },
      [&](std::uint32_t a, std::uint32_t b) { is_end[a] = is_end[b] = true; });
  const auto is_in_complex = [&](std::uint32_t i) {
    const auto ball = [&](std::uint32_t k) { return rbpa::space::Ball{balls.centers[k], balls.radii[k]}; };
    bool is_alone = true;
    for (std::uint32_t k = 0; k < is_end.size(); ++k)
      is_alone &= k == i || balls.centers[k] == balls.centers[i] || !rbpa::space::is_conflict(ball(i), ball(k));
    return is_end[i] || is_alone;
  };
  const rbpa::space::RegionMeasures measures = rbpa::space::outside_of_balls(
      {cells, balls.centers, balls.radii, region, 3,
       [&](std::uint32_t t, std::size_t k) { return faces.has_triangle(t, k); },
       [&](std::span<const rbpa::space::EdgeAt> ring) { return faces.has_edge(ring); }, is_in_complex},
      one);
  const rbpa::BallMeasures expected = rbpa::measure_balls(balls.centers, balls.radii, regular, {});
  double outside = 0, tetrahedra = 0;
  for (const auto& of : measures.all) {
    outside += of.volume;
    tetrahedra += of.tetrahedra;
  }
  CHECK(tetrahedra + in_complex == Approx(whole).epsilon(1e-12));
  CHECK(std::abs(whole - outside - expected.volume) <= 1e-13 * whole);
  std::vector<double> areas(balls.radii.size(), 0);
  for (const auto& share : measures.shares) areas[share.ball] += share.area;
  for (std::size_t i = 0; i < areas.size(); ++i)
    CHECK(std::abs(areas[i] - expected.areas[i]) <= 1e-11 * balls.radii[i] * balls.radii[i]);
}

}  // namespace

TEST_CASE("voids and mouths agree with random points: shells with balls within") {
  std::size_t voids = 0, pockets = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const Balls balls = shell(60, static_cast<int>(seed % 3 * 3), 0.33, 0.48, seed % 2 == 0 ? 0 : 0.04, seed);
    const BallVoids found = find_voids(balls);
    voids += found.voids.size();
    pockets += found.pockets.size();
    check_by_random_points(balls, 4000, seed);
  }
  CHECK(voids >= 4);
  CHECK(pockets >= 2);
}

TEST_CASE("what the balls leave of all tetrahedra sums up to what their union leaves") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) check_sums(shell(40, 5, 0.1, 0.5, 0.1, seed));
  Random random(3);
  for (int set = 0; set < 200; ++set) {
    const auto kind = static_cast<RadiusKind>(set % radius_kinds);
    const Balls balls = ball_set(set % 2 == 0 ? SpaceKind::grid : SpaceKind::cube, kind, 20, random);
    CAPTURE(text(balls));
    check_sums(balls);
  }
}

TEST_CASE("lysozyme has ten voids for a probe of 1.4") {
  const Balls atoms = lysozyme(1.4);
  const BallVoids found = find_voids(atoms);
  CHECK(found.voids.size() == 10);
  CHECK(found.pockets.size() == 7);
  CHECK(found.voids[0].volume == Approx(4.75455).epsilon(1e-5));
  check_by_random_points(atoms, 2000, 1);
}

TEST_SUITE_END();

#include "rbpa/space/balls/weighted_filtration.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/space/balls/ball_voids.h"
#include "rbpa/space/balls/measure_balls.h"
#include "rbpa/space/balls/regular_triangulation.h"
#include "rbpa/space/persistence/solid_persistence.h"
#include "rbpa/space/predicate/orthosphere.h"
#include "support/ball_sets.h"
#include "support/infinity.h"
#include "support/solid_sets.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::SolidFiltration;
using rbpa::SolidPair;
using rbpa::space::Ball;
using rbpa::space::is_conflict;

TEST_SUITE_BEGIN("space");

namespace {

using Simplex = std::vector<std::uint32_t>;
using Values = std::map<Simplex, double>;

SolidFiltration filtration_of(const Balls& balls, bool roots = false) {
  return rbpa::weighted_filtration(balls.centers, balls.radii, {.roots = roots});
}

/// Returns the value of each simplex, whose corners ascend.
Values values_of(const SolidFiltration& filtration) {
  Values values;
  const auto add = [&](const auto& simplices, const std::vector<double>& alpha) {
    REQUIRE(simplices.size() == alpha.size());
    for (std::size_t i = 0; i < alpha.size(); ++i) {
      Simplex corners(simplices[i].begin(), simplices[i].end());
      std::sort(corners.begin(), corners.end());
      CHECK(values.emplace(corners, alpha[i]).second);
    }
  };
  add(filtration.delaunay.simplices, filtration.tetrahedron_alpha);
  add(filtration.triangles, filtration.triangle_alpha);
  add(filtration.edges, filtration.edge_alpha);
  for (std::uint32_t i = 0; i < filtration.point_alpha.size(); ++i)
    if (!std::isinf(filtration.point_alpha[i])) values[{i}] = filtration.point_alpha[i];
  return values;
}

/// Returns the values by definition: that of the orthocenter if none of all balls conflicts, else the least value of a
/// simplex of one more ball.
Values by_definition(const Balls& balls, const Values& simplices, bool roots) {
  Values expected;
  for (std::size_t corners = 4; corners > 0; --corners)
    for (const auto& entry : simplices) {
      const auto& simplex = entry.first;
      if (simplex.size() != corners) continue;
      std::vector<Ball> own;
      for (const std::uint32_t i : simplex) own.push_back({balls.centers[i], balls.radii[i]});
      const auto conflicts = [&](std::uint32_t i) {
        if (corners == 4 || std::find(simplex.begin(), simplex.end(), i) != simplex.end()) return false;
        const Ball q = {balls.centers[i], balls.radii[i]};
        return corners == 3   ? is_conflict(own[0], own[1], own[2], q)
               : corners == 2 ? is_conflict(own[0], own[1], q)
                              : is_conflict(own[0], q);
      };
      bool is_alone = true;
      for (std::uint32_t i = 0; i < balls.centers.size(); ++i) is_alone &= !conflicts(i);
      double least = infinity;
      for (const auto& [other, its] : expected)
        if (other.size() == corners + 1 && std::includes(other.begin(), other.end(), simplex.begin(), simplex.end()))
          least = std::min(least, its);
      expected[simplex] = is_alone ? rbpa::space::least_power_rounded_up(own, roots) : least;
    }
  return expected;
}

std::size_t alive_at_zero(const std::vector<SolidPair>& pairs, int dimension) {
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const SolidPair& pair) {
    return pair.dimension == dimension && pair.birth <= 0 && !(pair.death && *pair.death <= 0);
  }));
}

template <typename Check>
void for_each_set(std::uint64_t trials, std::size_t count, const Check& check) {
  for (int k = 0; k < space_kinds; ++k)
    for (int r = 0; r < radius_kinds; ++r) {
      Random random(5100 + static_cast<std::uint64_t>(k * radius_kinds + r));
      CAPTURE(name(static_cast<SpaceKind>(k)));
      CAPTURE(name(static_cast<RadiusKind>(r)));
      for (std::uint64_t trial = 0; trial < trials; ++trial)
        check(ball_set(static_cast<SpaceKind>(k), static_cast<RadiusKind>(r), 1 + random.below(count), random));
    }
}

}  // namespace

TEST_CASE("each simplex enters at the power of its definition, of all balls and not only of those around it") {
  std::size_t alone = 0, simplices = 0;
  for_each_set(3, 14, [&](const Balls& balls) {
    for (const bool roots : {false, true}) {
      const Values values = values_of(filtration_of(balls, roots));
      const Values expected = by_definition(balls, values, roots);
      if (values != expected) FAIL_CHECK(text(balls));
      simplices += values.size();
      for (const auto& [simplex, value] : values)
        alone += simplex.size() < 4 &&
                 !std::any_of(values.begin(), values.end(), [&, &own = simplex, of = value](const auto& other) {
                   return other.second == of && other.first.size() == own.size() + 1 &&
                          std::includes(other.first.begin(), other.first.end(), own.begin(), own.end());
                 });
    }
  });
  CHECK(simplices > 20000);
  CHECK(alone > 2000);
}

TEST_CASE("simplices are those of the regular triangulation, and the dual complex has those of power at most 0") {
  std::size_t edges = 0, hidden = 0, voids = 0;
  const auto check = [&](const Balls& balls) {
    const SolidFiltration filtration = filtration_of(balls);
    const rbpa::RegularTriangulation regular = rbpa::regular_triangulation(balls.centers, balls.radii);
    CHECK(filtration.delaunay.simplices.size() == regular.simplices.size());
    CHECK(filtration.delaunay.duplicates == regular.duplicates);
    CHECK(filtration.delaunay.isolated == regular.hidden);
    CHECK(filtration.delaunay.distinct == regular.distinct);
    Values values = values_of(filtration);
    for (auto row : regular.simplices) {
      std::sort(row.begin(), row.end());
      CHECK(values.contains(Simplex(row.begin(), row.end())));
    }
    for (const auto& row : regular.flat)
      CHECK(values.contains(Simplex(row.begin(), std::find(row.begin(), row.end(), rbpa::RegularTriangulation::none))));
    double size = 0;  // with far lengths, squares do not fit
    for (const Point3& p : balls.centers) size = std::max({size, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (size > 1e100) return;

    const rbpa::BallMeasures measures =
        rbpa::measure_balls(balls.centers, balls.radii, {.contacts = true, .threads = 1});
    std::vector<std::array<std::uint32_t, 2>> within, expected;
    for (std::size_t i = 0; i < filtration.edges.size(); ++i)
      if (filtration.edge_alpha[i] <= 0) within.push_back(filtration.edges[i]);
    std::sort(within.begin(), within.end());
    for (const rbpa::BallContact& contact : measures.contacts) expected.push_back(contact.balls);
    if (within != expected) FAIL_CHECK(text(balls));
    std::vector<std::uint32_t> not_within;
    for (std::uint32_t i = 0; i < filtration.point_alpha.size(); ++i)
      if (filtration.point_alpha[i] > 0) not_within.push_back(i);
    CHECK(not_within == measures.hidden);
    const std::vector<SolidPair> pairs = rbpa::solid_persistence(filtration);
    const rbpa::BallVoids found = rbpa::ball_voids(balls.centers, balls.radii, regular);
    CHECK(alive_at_zero(pairs, 2) == found.voids.size());
    edges += within.size();
    hidden += not_within.size();
    voids += found.voids.size();
  };
  for_each_set(2, 40, check);
  Random random(5112);
  for (int trial = 0; trial < 40; ++trial) {
    Balls balls;  // of about the distance of neighbors
    for (int i = 0; i < 150; ++i) {
      balls.centers.push_back({random.unit(), random.unit(), random.unit()});
      balls.radii.push_back(random.between(0.1, 0.2));
    }
    check(balls);
  }
  CHECK(edges > 2000);
  CHECK(hidden > 500);
  CHECK(voids > 20);
}

TEST_CASE("the roots of points are the filtration of points, bit by bit, flat sets too") {
  std::size_t compared = 0;
  for (const SolidSet& set : solid_sets(60)) {
    CAPTURE(set.name);
    const std::vector<double> radii(set.points.size(), 0);
    const SolidFiltration balls = rbpa::weighted_filtration(set.points, radii, {.roots = true});
    SolidFiltration points = rbpa::solid_filtration(set.points);
    points.point_alpha.assign(set.points.size(), 0);
    for (const rbpa::Duplicate& d : points.delaunay.duplicates) points.point_alpha[d.index] = infinity;
    CHECK(values_of(balls) == values_of(points));
    if (set.is_solid) {
      CHECK(balls.delaunay.simplices == points.delaunay.simplices);
      CHECK(rbpa::solid_persistence(balls) == rbpa::solid_persistence(rbpa::solid_filtration(set.points)));
      ++compared;
    }
  }
  CHECK(compared > 10);
}

TEST_CASE("two balls: each begins at minus its squared radius, and the later one ends where they touch") {
  // x² + p = 4 + p and (5 − x)² = 9 + p meet where x = 2: p = 0.
  const Points3 centers = {{5, 0, 0}, {0, 0, 0}};
  const std::vector<double> radii = {3, 2};
  const std::vector<SolidPair> pairs = rbpa::solid_persistence(rbpa::weighted_filtration(centers, radii));
  REQUIRE(pairs.size() == 2);
  CHECK(pairs[0] == SolidPair{.dimension = 0, .birth = -9, .death = {}, .born_by = 0});
  CHECK(pairs[1] == SolidPair{.dimension = 0, .birth = -4, .death = 0, .born_by = 1, .ended_by = 0});
  const std::vector<SolidPair> roots =
      rbpa::solid_persistence(rbpa::weighted_filtration(centers, radii, {.roots = true}));
  REQUIRE(roots.size() == 2);
  CHECK(roots[0].birth == -3);
  CHECK(roots[1].birth == -2);
}

TEST_CASE("a ball whose center is in the cell of another begins where its cell does") {
  // The plane of equal power is at x = (1 + 16 − 1) / 2 = 8, where the power is 64 − 16 = 48.
  const SolidFiltration two = rbpa::weighted_filtration(Points3{{0, 0, 0}, {1, 0, 0}}, std::vector<double>{4, 1});
  CHECK(two.point_alpha == std::vector<double>{-16, 48});
  CHECK(two.edge_alpha == std::vector<double>{48});
  CHECK(rbpa::solid_persistence(two).size() == 1);
}

TEST_CASE("grown by a constant power, balls have the same filtration later") {
  Random random(5110);
  Points3 centers;
  std::vector<double> radii, grown;  // with the squares 144 + 0, 5², 9², 16², 35²
  for (int i = 0; i < 64; ++i) {
    centers.push_back({32.0 * (i & 3), 32.0 * (i >> 2 & 3), 32.0 * (i >> 4)});
    const std::size_t kind = random.below(5);
    radii.push_back(std::array{0.0, 5.0, 9.0, 16.0, 35.0}[kind]);
    grown.push_back(std::array{12.0, 13.0, 15.0, 20.0, 37.0}[kind]);
  }
  const std::vector<SolidPair> early = rbpa::solid_persistence(rbpa::weighted_filtration(centers, grown));
  const std::vector<SolidPair> late = rbpa::solid_persistence(rbpa::weighted_filtration(centers, radii));
  REQUIRE(early.size() == late.size());
  for (std::size_t i = 0; i < late.size(); ++i) {
    CHECK(early[i].birth == doctest::Approx(late[i].birth - 144));
    CHECK(early[i].born_by == late[i].born_by);
    CHECK(early[i].ended_by == late[i].ended_by);
  }
  CHECK(late.size() > 30);
}

TEST_CASE("squares beyond double are infinite, and ordered by dimension alone") {
  const Points3 centers = {{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}, {0, 0, 1e300}};
  const SolidFiltration far = rbpa::weighted_filtration(centers, std::vector<double>{1e200, 0, 0, 1e-200});
  CHECK(far.point_alpha[0] == -std::numeric_limits<double>::max());
  CHECK(far.point_alpha[3] == 0);  // the square is below the least double
  CHECK(far.tetrahedron_alpha == std::vector<double>{infinity});
  CHECK(rbpa::solid_persistence(far).size() == 4);
  const SolidFiltration roots =
      rbpa::weighted_filtration(centers, std::vector<double>{1e200, 0, 0, 1e-200}, {.roots = true});
  CHECK(roots.point_alpha == std::vector<double>{-1e200, 0, 0, -1e-200});
  CHECK(roots.tetrahedron_alpha[0] == doctest::Approx(std::sqrt(0.75) * 1e300));
}

TEST_CASE("no balls have no simplices, and threads make no difference") {
  const SolidFiltration none = rbpa::weighted_filtration({}, {});
  CHECK(none.point_alpha.empty());
  CHECK(rbpa::solid_persistence(none).empty());
  Random random(5111);
  Balls many;
  for (int i = 0; i < 12000; ++i) {
    many.centers.push_back({random.unit(), random.unit(), random.unit()});
    many.radii.push_back(0.03 * random.unit());
  }
  const SolidFiltration one = rbpa::weighted_filtration(many.centers, many.radii, {.threads = 1});
  const SolidFiltration more = rbpa::weighted_filtration(many.centers, many.radii, {.threads = 3});
  CHECK(one.tetrahedron_alpha == more.tetrahedron_alpha);
  CHECK(one.triangle_alpha == more.triangle_alpha);
  CHECK(one.edge_alpha == more.edge_alpha);
  CHECK(one.point_alpha == more.point_alpha);
}

TEST_CASE("wrong input is refused by the number of the ball, and a callback cancels") {
  CHECK_THROWS_WITH_AS(rbpa::weighted_filtration(Points3{{0, 0, 0}, {1, 0, 0}}, std::vector<double>{1, -1}),
                       "radius 1 is -1, expected a finite number of at least 0", rbpa::InvalidInput);
  const rbpa::OnProgress never = [](const rbpa::Progress&) { return false; };
  CHECK_THROWS_AS(rbpa::weighted_filtration(Points3(20000), std::vector<double>(20000), {.progress = never}),
                  rbpa::Cancelled);
}

TEST_SUITE_END();

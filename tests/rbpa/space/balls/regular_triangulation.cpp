#include "rbpa/space/balls/regular_triangulation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "oracle/rational_vector.h"
#include "rbpa/base/error.h"
#include "rbpa/space/solid/insertion/insertion.h"
#include "rbpa/space/solid/insertion/spatial_order.h"
#include "rbpa/space/solid/solid.h"
#include "support/arguments.h"
#include "support/ball_sets.h"
#include "support/infinity.h"
#include "support/order.h"

using namespace rbpa_test;
using rbpa::Point3;
using rbpa::regular_triangulation;
using rbpa::RegularTriangulation;

TEST_SUITE_BEGIN("space");

namespace {

constexpr std::uint32_t none = RegularTriangulation::none;
using Corners = std::array<std::uint32_t, 4>;

RegularTriangulation triangulated(const Balls& balls) { return regular_triangulation(balls.centers, balls.radii); }

int sign(const Rational& value) { return value.sign(); }

Rational volume(const Balls& balls, const Corners& t) {
  const Point3& a = balls.centers[t[0]];
  return dot(cross(rational_from(a, balls.centers[t[1]]), rational_from(a, balls.centers[t[2]])),
             rational_from(a, balls.centers[t[3]]));
}

/// Returns the sign of the perturbed lift of ball q above the hyperplane of four others, by the definition: with λ the
/// barycentric coordinates of its center, h(q) − Σ λ h(corner), and where that is 0, the terms of ε by descending order
/// of centers. 0 if q is a corner.
int height(const Balls& balls, const Corners& t, std::uint32_t q) {
  const auto lift = [&](std::uint32_t i) -> Rational {
    const Vector3<Rational> p = rational_from({0, 0, 0}, balls.centers[i]);
    const Rational radius = rational(balls.radii[i]);
    return dot(p, p) - radius * radius;
  };
  const Rational whole = volume(balls, t);
  Rational sum = lift(q);
  std::vector<std::pair<Point3, int>> terms = {{balls.centers[q], 1}};
  for (std::size_t k = 0; k < 4; ++k) {
    Corners replaced = t;
    replaced[k] = q;
    const Rational share = volume(balls, replaced) / whole;
    sum -= share * lift(t[k]);
    terms.emplace_back(balls.centers[t[k]], -sign(share));
  }
  if (sum != 0) return sign(sum);
  std::sort(terms.begin(), terms.end(), [](const auto& s, const auto& u) { return s.first > u.first; });
  if (terms[0].first == terms[1].first) return 0;  // q has the center of a corner
  for (const auto& [center, side] : terms)
    if (side != 0) return side;
  return 0;
}

/// Checks the definition: no ball conflicts with a tetrahedron; every center is behind every face without a neighbor;
/// and distinct balls are corners or hidden.
void check_definition(const Balls& balls, const RegularTriangulation& found) {
  const auto count = static_cast<std::uint32_t>(balls.radii.size());
  std::vector<bool> is_seen(count, false);
  const auto see = [&](std::uint32_t i) {
    const bool is_new = !is_seen[i];
    is_seen[i] = true;
    return is_new;
  };
  for (const auto* rows : {&found.simplices, &found.flat})
    for (const Corners& row : *rows)
      for (const std::uint32_t i : row)
        if (i != none) see(i);
  for (const std::uint32_t i : found.hidden) CHECK(see(i));
  CHECK(std::is_sorted(found.hidden.begin(), found.hidden.end()));
  for (const rbpa::Duplicate& d : found.duplicates) {
    CHECK(see(d.index));
    CHECK(d.stands_for < d.index);
    CHECK(balls.centers[d.index] == balls.centers[d.stands_for]);
    CHECK(balls.radii[d.index] == balls.radii[d.stands_for]);
  }
  CHECK(std::find(is_seen.begin(), is_seen.end(), false) == is_seen.end());
  CHECK(found.distinct + found.duplicates.size() == count);
  CHECK(std::is_sorted(found.simplices.begin(), found.simplices.end()));
  CHECK(found.neighbors.size() == found.simplices.size());
  for (std::uint32_t t = 0; t < found.simplices.size(); ++t) {
    const Corners& corners = found.simplices[t];
    CHECK(volume(balls, corners) > 0);
    for (std::uint32_t q = 0; q < count; ++q)
      if (std::find(corners.begin(), corners.end(), q) == corners.end()) CHECK(height(balls, corners, q) >= 0);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t other = found.neighbors[t][k];
      if (other != none) {
        CHECK(std::count(found.neighbors[other].begin(), found.neighbors[other].end(), t) == 1);
        for (std::size_t j = 0; j < 4; ++j)
          if (j != k) CHECK(std::count(found.simplices[other].begin(), found.simplices[other].end(), corners[j]) == 1);
        continue;
      }
      for (std::uint32_t q = 0; q < count; ++q) {
        Corners replaced = corners;
        replaced[k] = q;
        CHECK(volume(balls, replaced) >= 0);
      }
    }
  }
}

/// Returns rows of indices as rows of balls, each named by the least ball equal to it, sorted.
std::vector<Corners> named(const std::vector<Corners>& rows, const Balls& balls) {
  const auto of = [&](std::uint32_t i) { return std::tuple(balls.centers[i], balls.radii[i]); };
  std::vector<std::uint32_t> order(balls.radii.size()), name(order.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) { return of(i) < of(j); });
  for (std::uint32_t i = 0; i < order.size(); ++i)
    name[order[i]] = i > 0 && of(order[i - 1]) == of(order[i]) ? name[order[i - 1]] : i;
  std::vector<Corners> result = rows;
  for (Corners& row : result) {
    for (std::uint32_t& i : row) i = i == none ? none : name[i];
    std::sort(row.begin(), row.end());
  }
  std::sort(result.begin(), result.end());
  return result;
}

Balls shuffled(const Balls& balls, Random& random) {
  const std::vector<std::uint32_t> order = random_order(balls.radii.size(), random);
  Balls result;
  for (const std::uint32_t i : order) {
    result.centers.push_back(balls.centers[i]);
    result.radii.push_back(balls.radii[i]);
  }
  return result;
}

}  // namespace

TEST_CASE("no ball conflicts with a tetrahedron, the hull is complete, and all other balls are hidden") {
  std::size_t tetrahedra = 0, hidden = 0;
  for (int k = 0; k < space_kinds; ++k)
    for (int r = 0; r < radius_kinds; ++r) {
      Random random(300 + static_cast<std::uint64_t>(k * radius_kinds + r));
      CAPTURE(name(static_cast<SpaceKind>(k)));
      CAPTURE(name(static_cast<RadiusKind>(r)));
      for (int trial = 0; trial < trials(12); ++trial) {
        const Balls balls =
            ball_set(static_cast<SpaceKind>(k), static_cast<RadiusKind>(r), 1 + random.below(14), random);
        CAPTURE(text(balls));
        const RegularTriangulation found = triangulated(balls);
        check_definition(balls, found);
        tetrahedra += found.simplices.size();
        hidden += found.hidden.size();
      }
    }
  CHECK(tetrahedra > trials(6000));
  CHECK(hidden > trials(1000));
}

TEST_CASE("tetrahedra, hidden balls and flat simplices do not depend on the order of the balls") {
  for (int k = 0; k < space_kinds; ++k)
    for (int r = 0; r < radius_kinds; ++r) {
      Random random(500 + static_cast<std::uint64_t>(k * radius_kinds + r));
      const Balls balls = ball_set(static_cast<SpaceKind>(k), static_cast<RadiusKind>(r), 60, random);
      CAPTURE(name(static_cast<SpaceKind>(k)));
      CAPTURE(name(static_cast<RadiusKind>(r)));
      const RegularTriangulation found = triangulated(balls);
      for (int trial = 0; trial < 3; ++trial) {
        const Balls other = shuffled(balls, random);
        const RegularTriangulation again = triangulated(other);
        CHECK(named(again.simplices, other) == named(found.simplices, balls));
        CHECK(named(again.flat, other) == named(found.flat, balls));
        CHECK(again.hidden.size() == found.hidden.size());
        CHECK(again.distinct == found.distinct);
      }
    }
}

TEST_CASE("balls of equal radii have the tetrahedra of solid() at infinity, also when balls are inserted") {
  for (int k = 0; k < space_kinds; ++k) {
    Random random(600 + static_cast<std::uint64_t>(k));
    CAPTURE(name(static_cast<SpaceKind>(k)));
    Balls balls;
    balls.centers = space_set(static_cast<SpaceKind>(k), 200, random);
    balls.radii.assign(balls.centers.size(), std::abs(balls.centers[0].x));
    const rbpa::Solid expected = rbpa::solid(balls.centers, infinity);
    RegularTriangulation found = triangulated(balls);
    CHECK(found.simplices == expected.simplices);
    CHECK(found.neighbors == expected.neighbors);
    CHECK(found.duplicates == expected.duplicates);
    CHECK(found.distinct == expected.distinct);
    if (!found.simplices.empty()) CHECK(found.hidden.empty());
    // A smaller ball at a center is hidden, and the radii are not equal.
    balls.centers.push_back(balls.centers[0]);
    balls.radii.push_back(balls.radii[0] / 2);
    if (balls.radii[0] == 0) continue;
    found = triangulated(balls);
    CHECK(found.simplices == expected.simplices);
    CHECK(found.neighbors == expected.neighbors);
    CHECK(std::count(found.hidden.begin(), found.hidden.end(), balls.radii.size() - 1) == 1);
  }
}

TEST_CASE("simplices of balls in a plane or on a line are the faces across from any further balls") {
  Random random(700);
  std::size_t triangles = 0, edges = 0;
  for (const SpaceKind kind : {SpaceKind::plane, SpaceKind::plane_grid, SpaceKind::line})
    for (int r = 0; r < radius_kinds; ++r)
      for (int trial = 0; trial < 20; ++trial) {
        CAPTURE(name(kind));
        CAPTURE(name(static_cast<RadiusKind>(r)));
        Balls balls = ball_set(kind, static_cast<RadiusKind>(r), 1 + random.below(20), random);
        const RegularTriangulation found = triangulated(balls);
        CHECK(found.simplices.empty());
        CHECK(found.flat.empty() == balls.radii.empty());
        check_definition(balls, found);
        std::size_t corners = 0;
        if (!found.flat.empty())
          for (const std::uint32_t i : found.flat[0]) corners += i != none ? 1u : 0u;
        (corners == 3 ? triangles : edges) += found.flat.size();
        // One ball off the plane; or as many as are needed.
        const auto count = static_cast<std::uint32_t>(balls.radii.size());
        for (std::size_t i = corners; i < 4; ++i) {
          balls.centers.push_back({random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)});
          balls.radii.push_back(random.between(0, 20));
        }
        const RegularTriangulation joined = triangulated(balls);
        std::vector<Corners> faces;
        for (Corners row : joined.simplices) {
          for (std::uint32_t& i : row) i = i < count ? i : none;
          std::sort(row.begin(), row.end());
          faces.push_back(row);
        }
        std::sort(faces.begin(), faces.end());
        CHECK(faces == found.flat);
        CHECK(joined.hidden == found.hidden);
      }
  CHECK(triangles > 500);
  CHECK(edges > 300);
}

TEST_CASE("an inner ball is hidden exactly if the others' common orthogonal sphere has no negative power to it") {
  // The center of a regular tetrahedron's cube corners: lifts are 3 − R², the center's −r².
  const double root = std::sqrt(3.0);
  for (const auto& [corner_radius, inner_radius, is_hidden] : {std::tuple(2.0, 1.0, false),
                                                               {2.0, 0.9999, true},
                                                               {2.0, std::nextafter(1.0, 0), true},
                                                               {root, 0.0, false},
                                                               {std::nextafter(root, 2), 0.0, true},
                                                               {1.0, 0.0, false},
                                                               {2.5, 1.8, true},
                                                               {2.5, 1.81, false}}) {
    const auto& shown_corner_radius = corner_radius;
    CAPTURE(shown_corner_radius);
    const auto& shown_inner_radius = inner_radius;
    CAPTURE(shown_inner_radius);
    const Balls balls = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {0, 0, 0}},
                         {corner_radius, corner_radius, corner_radius, corner_radius, inner_radius}};
    const RegularTriangulation found = triangulated(balls);
    CHECK(found.hidden.size() == (is_hidden ? 1u : 0u));
    CHECK(found.simplices.size() == (is_hidden ? 1u : 4u));
  }
}

TEST_CASE("a ball that comes later hides earlier ones, whatever their number") {
  Random random(800);
  Balls balls = ball_set(SpaceKind::cube, RadiusKind::spacing, 3000, random);
  balls.centers.push_back({0.1, 0.2, 0.3});
  balls.radii.push_back(1.7);
  const RegularTriangulation found = triangulated(balls);
  CHECK(found.hidden.size() > 2500);
  const Balls other = shuffled(balls, random);
  CHECK(named(triangulated(other).simplices, other) == named(found.simplices, balls));
}

TEST_CASE("of balls with one center the largest has a cell, and the first of equal ones stands for all") {
  const Balls balls = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {-0.0, 0, 0}, {0, 0, 0}, {1, 0, 0}},
                       {0.1, 0.5, 0.5, 0.5, 0.7, 0.7, 0.1, 0.5}};
  const RegularTriangulation found = triangulated(balls);
  CHECK(found.simplices == std::vector<Corners>{{1, 2, 4, 3}});
  CHECK(found.hidden == std::vector<std::uint32_t>{0});
  CHECK(found.duplicates == std::vector<rbpa::Duplicate>{{5, 4}, {6, 0}, {7, 1}});
  CHECK(found.distinct == 5);
}

TEST_CASE("no balls, one ball and balls of one center have no tetrahedra") {
  CHECK(triangulated({}).flat.empty());
  CHECK(triangulated({}).distinct == 0);
  CHECK(triangulated({{{3, 0, -1}}, {2}}).flat == std::vector<Corners>{{0, none, none, none}});
  const RegularTriangulation found = triangulated({{{0, 0, 0}, {0, 0, 0}}, {1, 2}});
  CHECK(found.flat == std::vector<Corners>{{1, none, none, none}});
  CHECK(found.hidden == std::vector<std::uint32_t>{0});
}

TEST_CASE("balls that are not finite, or negative, are refused") {
  const Points3 centers = {{0, 0, 0}, {1, 0, 0}};
  const auto refused = [&](const Points3& c, std::vector<double> radii) {
    CHECK_THROWS_AS(regular_triangulation(c, radii), rbpa::InvalidInput);
  };
  refused(centers, {1});
  refused(centers, {1, -1e-300});
  refused(centers, {1, infinity});
  refused(centers, {1, std::nan("")});
  refused({{0, 0, 0}, {infinity, 0, 0}}, {1, 1});
}

TEST_CASE("a triangulation of balls can be cancelled") {
  Random random(801);
  const Balls balls = ball_set(SpaceKind::cube, RadiusKind::spacing, 20'000, random);
  std::size_t calls = 0;
  rbpa::SolidOptions options;
  options.progress = [&](const rbpa::Progress&) { return ++calls < 4; };
  CHECK_THROWS_AS(regular_triangulation(balls.centers, balls.radii, options), rbpa::Cancelled);
  CHECK(calls == 4);
}

TEST_SUITE_END();

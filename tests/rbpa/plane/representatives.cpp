#include "rbpa/plane/representatives.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/triangles_by_level.h"
#include "support/delaunay_arrays.h"
#include "support/generate.h"
#include "support/infinity.h"

using namespace rbpa_test;
using rbpa::ComplexKind;
using rbpa::PersistencePair;
using rbpa::Point;
using rbpa::Representative;

TEST_SUITE_BEGIN("filtration");

namespace {

double area(const Points& points, const rbpa::Triangle& t) {
  const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
  return ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2;
}

/// Returns the areas of the holes of a complex: sets of Delaunay triangles outside of it, joined across edges outside
/// of it.
std::vector<double> hole_areas(const Points& points, const rbpa::AlphaComplex& delaunay, double alpha,
                               ComplexKind kind) {
  const rbpa::AlphaComplex complex = rbpa::alpha_complex(points, alpha, {.complex = rbpa::ComplexKind::full});
  std::set<rbpa::Triangle> triangles(complex.triangles.begin(), complex.triangles.end());
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  if (kind == ComplexKind::full)
    for (const auto& edge : complex.edges) edges.emplace(edge[0], edge[1]);
  const auto outside = static_cast<std::uint32_t>(delaunay.triangles.size());
  meshops::DisjointSets sets(outside + 1);
  for (std::uint32_t t = 0; t < outside; ++t) {
    if (triangles.contains(delaunay.triangles[t])) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t beyond = delaunay.neighbors[t][k];
      const auto side = std::minmax({delaunay.triangles[t][(k + 1) % 3], delaunay.triangles[t][(k + 2) % 3]});
      if (edges.contains(side)) continue;
      if (beyond == rbpa::AlphaComplex::none)
        sets.join(t, outside);
      else if (!triangles.contains(delaunay.triangles[beyond]))
        sets.join(t, beyond);
    }
  }
  std::vector<double> of(outside + 1, 0);
  for (std::uint32_t t = 0; t < outside; ++t)
    if (!triangles.contains(delaunay.triangles[t])) of[sets.find(t)] += area(points, delaunay.triangles[t]);
  std::vector<double> areas;
  for (std::uint32_t t = 0; t < outside; ++t)
    if (of[t] > 0 && sets.find(t) != sets.find(outside)) areas.push_back(of[t]);
  return areas;
}

}  // namespace

TEST_CASE("a hole at its birth is a hole of the complex, made of triangles outside of it") {
  std::size_t holes = 0, nested = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const Points points = trial % 2 == 0 ? uniform(40, 1700 + static_cast<std::uint64_t>(trial))
                                         : random_grid(6, 30, false, static_cast<std::uint64_t>(trial));
    const auto delaunay = delaunay_arrays(points);
    if (delaunay.triangles.empty()) continue;
    const auto filtration = rbpa::filtration(delaunay, points);
    const rbpa::Delaunay checked(delaunay, points);
    for (const ComplexKind kind : {ComplexKind::solid, ComplexKind::full}) {
      const auto all = rbpa::representatives(checked, filtration, kind);
      std::vector<PersistencePair> pairs;
      for (const Representative& one : all) pairs.push_back(one.pair);
      CHECK(pairs == rbpa::persistence(checked, filtration, kind));
      for (const Representative& one : all) {
        if (one.pair.dimension == 0) {
          CHECK(one.joined_at.has_value() == one.pair.death.has_value());
          continue;
        }
        const std::vector<double> areas = hole_areas(points, delaunay, one.pair.birth, kind);
        CHECK(std::any_of(areas.begin(), areas.end(),
                          [&](double a) { return std::abs(a - one.at_birth.area) <= 1e-9 * a; }));
        CHECK(one.before_death.area <= one.at_birth.area * (1 + 1e-12));
        CHECK(one.before_death.area > 0);
        const std::vector<double> before = hole_areas(points, delaunay, std::nextafter(*one.pair.death, 0.0), kind);
        CHECK(std::any_of(before.begin(), before.end(),
                          [&](double a) { return std::abs(a - one.before_death.area) <= 1e-9 * a; }));
        nested += one.at_birth.holes.empty() ? 0u : 1u;
        ++holes;
      }
    }
  }
  CHECK(holes > 500);
  CHECK(nested > 0);
}

TEST_CASE("an edge that ends a component is twice as long as its death, in the full complex") {
  const Points points = uniform(300, 1701);
  const auto delaunay = delaunay_arrays(points);
  const rbpa::Delaunay checked(delaunay, points);
  std::size_t edges = 0;
  for (const Representative& one :
       rbpa::representatives(checked, rbpa::filtration(delaunay, points), ComplexKind::full)) {
    if (!one.joined_at) continue;
    const Point &a = points[(*one.joined_at)[0]], &b = points[(*one.joined_at)[1]];
    CHECK(*one.pair.death == doctest::Approx(std::hypot(b.x - a.x, b.y - a.y) / 2));
    ++edges;
  }
  CHECK(edges == 299);
}

TEST_CASE("the most persistent pairs of each dimension are chosen") {
  const Points points = uniform(400, 1702);
  const auto delaunay = delaunay_arrays(points);
  const rbpa::Delaunay checked(delaunay, points);
  const auto filtration = rbpa::filtration(delaunay, points);
  const auto persistence = [](const PersistencePair& pair) { return pair.death.value_or(infinity) - pair.birth; };
  const auto all = rbpa::persistence(checked, filtration);
  for (const std::size_t top : {std::size_t{1}, std::size_t{7}}) {
    const auto found = rbpa::representatives(checked, filtration, ComplexKind::solid, {.top = top});
    for (const int dimension : {0, 1}) {
      std::vector<double> expected, chosen;
      for (const PersistencePair& pair : all)
        if (pair.dimension == dimension) expected.push_back(persistence(pair));
      for (const Representative& one : found)
        if (one.pair.dimension == dimension) chosen.push_back(persistence(one.pair));
      std::sort(expected.rbegin(), expected.rend());
      std::sort(chosen.rbegin(), chosen.rend());
      expected.resize(top);
      CHECK(chosen == expected);
    }
  }
  const double least = 0.02;
  const auto found = rbpa::representatives(checked, filtration, ComplexKind::solid, {.min_persistence = least});
  CHECK(found.size() > 3);
  CHECK(found.size() ==
        static_cast<std::size_t>(std::count_if(
            all.begin(), all.end(), [&](const PersistencePair& pair) { return persistence(pair) >= least; })));
}

TEST_CASE("levels list the first and the last of the holes that exist") {
  std::size_t holes = 0, left = 0, several = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const Points points = trial % 2 == 0 ? uniform(60, 1710 + static_cast<std::uint64_t>(trial))
                                         : random_grid(7, 36, false, static_cast<std::uint64_t>(trial));
    const auto delaunay = delaunay_arrays(points);
    if (delaunay.triangles.empty()) continue;
    const auto filtration = rbpa::filtration(delaunay, points);
    const rbpa::Delaunay checked(delaunay, points);
    std::vector<double> levels;
    if (trial % 3 == 0)
      for (const rbpa::ArrayLevel& level : rbpa::triangles_by_level(points, infinity, {.leaf_capacity = 4}).levels)
        levels.push_back(level.alpha);
    else  // close to each other, and not up to the end
      for (std::size_t i = 0; i < filtration.steps.size() / 2; i += 3) levels.push_back(filtration.steps[i].alpha);
    for (const ComplexKind kind : {ComplexKind::solid, ComplexKind::full}) {
      const auto all = rbpa::level_representatives(checked, filtration, levels, kind);
      for (const double level : levels) {
        const std::vector<double> expected = hole_areas(points, delaunay, level, kind);
        std::size_t there = 0;
        for (const Representative& one : all) {
          if (one.pair.dimension == 0) continue;
          there += one.pair.birth <= level && level < one.pair.death.value_or(infinity) ? 1u : 0u;
          const bool is_last = level >= one.pair.birth && level < one.pair.death.value_or(infinity) &&
                               (level == levels.back() || *(std::upper_bound(levels.begin(), levels.end(), level)) ==
                                                              one.pair.death.value_or(infinity));
          const auto is_one = [&](const rbpa::Polygon& hole) {
            return std::any_of(expected.begin(), expected.end(),
                               [&](double a) { return std::abs(a - hole.area) <= 1e-9 * a; });
          };
          if (one.pair.birth == level) CHECK(is_one(one.at_birth));
          if (is_last) CHECK(is_one(one.before_death));
        }
        CHECK(there == expected.size());
      }
      for (const Representative& one : all) {
        CHECK(std::find(levels.begin(), levels.end(), one.pair.birth) != levels.end());
        if (one.pair.death) CHECK(std::find(levels.begin(), levels.end(), *one.pair.death) != levels.end());
        CHECK(one.joined_at.has_value() == (one.pair.dimension == 0 && one.pair.death.has_value()));
        if (one.pair.dimension == 0) continue;
        ++holes;
        left += one.pair.death ? 0u : 1u;
        several += one.at_birth == one.before_death ? 0u : 1u;
      }
    }
  }
  CHECK(holes > 300);
  CHECK(left > 20);
  CHECK(several > 20);
  const Points points = uniform(50, 1705);
  const rbpa::Delaunay delaunay(points);
  const auto filtration = rbpa::filtration(delaunay);
  CHECK(rbpa::level_representatives(delaunay, filtration, {}).empty());
  const std::vector<double> same = {0.1, 0.1}, zero = {0, 0.1};
  CHECK_THROWS_AS(rbpa::level_representatives(delaunay, filtration, same), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::level_representatives(delaunay, filtration, zero), meshops::ContractViolation);
}

TEST_CASE("a filtration of another triangulation is refused, and a run can be cancelled") {
  const Points points = uniform(2000, 1703), others = uniform(1999, 1704);
  const rbpa::Delaunay delaunay(points), other(others);
  CHECK_THROWS_AS(rbpa::representatives(delaunay, rbpa::filtration(other)), meshops::ContractViolation);
  CHECK_THROWS_AS(
      rbpa::representatives(delaunay, rbpa::filtration(delaunay), ComplexKind::solid, {}, [] { return false; }),
      rbpa::Cancelled);
  const Points line = {{0, 0}, {1, 0}, {3, 0}};
  const rbpa::Delaunay flat(line);
  CHECK(rbpa::representatives(flat, rbpa::filtration(flat)).empty());
  CHECK(rbpa::representatives(flat, rbpa::filtration(flat), ComplexKind::full).size() == 3);
}

#include "rbpa/plane/filtration_arrays.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "plane/filtration/small_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/filtration/least_alpha.h"
#include "rbpa/plane/predicate/predicates.h"
#include "rbpa/rbpa.h"
#include "support/delaunay_arrays.h"
#include "support/generate.h"
#include "support/random.h"

using namespace rbpa_test;
using rbpa::FiltrationArrays;
using rbpa::FiltrationStep;
using rbpa::PersistencePair;
using rbpa::PlacedPair;
using rbpa::Point;

TEST_SUITE_BEGIN("filtration");

namespace {

struct Made {
  explicit Made(const Points& points)
      : delaunay(delaunay_arrays(points)),
        filtration(rbpa::filtration(delaunay, points)),
        arrays(rbpa::filtration_arrays(delaunay, points, filtration)) {}
  rbpa::AlphaComplex delaunay;
  rbpa::Filtration filtration;
  FiltrationArrays arrays;
};

using Corners = std::set<Point>;

std::set<Corners> corners_of(const std::vector<std::array<std::uint32_t, 3>>& triangles, const Points& points,
                             std::size_t count) {
  std::set<Corners> result;
  for (std::size_t t = 0; t < count; ++t)
    result.insert({points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]});
  return result;
}

/// Returns the triangles at each edge, by its ends.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> edges_of(const FiltrationArrays& arrays) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> edges;
  for (std::uint32_t t = 0; t < arrays.triangles.size(); ++t)
    for (unsigned i = 0; i < 3; ++i)
      edges[std::minmax({arrays.triangles[t][i], arrays.triangles[t][(i + 1) % 3]})].push_back(t);
  return edges;
}

bool is_alive(const PersistencePair& pair, double alpha) {
  return pair.birth <= alpha && (!pair.death || alpha < *pair.death);
}

/// Counts how often each set contains the triangle of a pair that is alive.
std::vector<int> pairs_in(const FiltrationArrays& arrays, int dimension, double alpha, meshops::DisjointSets& sets,
                          std::size_t count) {
  std::vector<int> found(count, 0);
  for (const PlacedPair& p : arrays.pairs)
    if (p.pair.dimension == dimension && is_alive(p.pair, alpha)) ++found[sets.find(p.triangle)];
  return found;
}

}  // namespace

TEST_CASE("the triangles of a step are a prefix of the list, and form the complex at its alpha") {
  on_small_sets([&](const Points& points) {
    const Made made(points);
    CHECK(made.arrays.points.size() == made.filtration.distinct);
    CHECK(std::is_sorted(made.arrays.points.begin(), made.arrays.points.end()));
    CHECK(std::is_sorted(made.arrays.alpha.begin(), made.arrays.alpha.end()));
    for (std::size_t t = 1; t < made.arrays.alpha.size(); ++t)
      if (made.arrays.alpha[t - 1] == made.arrays.alpha[t])
        CHECK(made.arrays.triangles[t - 1] < made.arrays.triangles[t]);
    std::size_t i = 0;
    for (const FiltrationStep& step : made.filtration.steps) {
      CHECK(made.arrays.alpha[step.triangles - 1] == step.alpha);
      if (i++ % 7 != 0) continue;
      const auto expected = rbpa::triangles(rbpa::rbpa(points, step.alpha));
      CHECK(corners_of(made.arrays.triangles, made.arrays.points, step.triangles) ==
            corners_of(expected, points, expected.size()));
    }
  });
}

TEST_CASE("pairs are those of persistence, and their triangles appear at their alphas") {
  on_small_sets([&](const Points& points) {
    const Made made(points);
    std::vector<PersistencePair> pairs;
    for (const PlacedPair& p : made.arrays.pairs) {
      pairs.push_back(p.pair);
      CHECK(made.arrays.alpha[p.triangle] == (p.pair.dimension == 0 ? p.pair.birth : *p.pair.death));
    }
    CHECK(pairs == rbpa::persistence(made.delaunay, points, made.filtration));
  });
}

TEST_CASE("each component has the triangle of one pair that is alive, and so has each hole") {
  on_small_sets([&](const Points& points) {
    const Made made(points);
    const auto edges = edges_of(made.arrays);
    const auto count = static_cast<std::uint32_t>(made.arrays.triangles.size());
    std::size_t i = 0;
    for (const FiltrationStep& step : made.filtration.steps) {
      if (i++ % 5 != 0) continue;
      meshops::DisjointSets pieces(count), gaps(count + 1);
      std::map<std::uint32_t, std::uint32_t> at;
      for (std::uint32_t t = 0; t < step.triangles; ++t)
        for (const std::uint32_t corner : made.arrays.triangles[t])
          pieces.join(t, at.try_emplace(corner, t).first->second);
      for (const auto& [ends, sides] : edges)
        if (sides.front() >= step.triangles) gaps.join(sides.front(), sides.size() > 1 ? sides.back() : count);
      const auto in_pieces = pairs_in(made.arrays, 0, step.alpha, pieces, count + 1);
      const auto in_gaps = pairs_in(made.arrays, 1, step.alpha, gaps, count + 1);
      for (std::uint32_t t = 0; t < step.triangles; ++t)
        if (pieces.find(t) == t) CHECK(in_pieces[t] == 1);
      for (auto t = static_cast<std::uint32_t>(step.triangles); t < count; ++t)
        if (gaps.find(t) == t) CHECK(in_gaps[t] == (gaps.find(count) == t ? 0 : 1));
    }
  });
}

TEST_CASE("free edges are those with an empty circle on their diameter that is smaller than their triangles' circles") {
  using Exact = rbpa::Predicates<long double>;
  for (const SmallSet& set : small_sets()) {
    CAPTURE(set.name);
    const Made made(set.points);
    const Points& points = made.arrays.points;
    std::vector<rbpa::FreeEdge> expected;
    for (const auto& [ends, sides] : edges_of(made.arrays)) {
      const Point &a = points[ends.first], &b = points[ends.second];
      const double half = rbpa::least_alpha(a, b);
      const bool empty =
          std::none_of(points.begin(), points.end(), [&](const Point& p) { return Exact::dot_sign(p, a, b) < 0; });
      if (!empty || half == made.arrays.alpha[sides.front()]) continue;
      const auto& corners = made.arrays.triangles[sides.front()];
      std::uint32_t side = 0;
      while (std::minmax({corners[side], corners[(side + 1) % 3]}) != ends) ++side;
      expected.push_back({half, sides.front(), side});
    }
    std::sort(expected.begin(), expected.end(), [](const rbpa::FreeEdge& a, const rbpa::FreeEdge& b) {
      return std::tie(a.alpha, a.triangle, a.side) < std::tie(b.alpha, b.triangle, b.side);
    });
    CHECK(made.arrays.free_edges == expected);
  }
}

TEST_CASE("the order of the points, and duplicates, do not change the arrays") {
  Random random(11);
  on_small_sets([&](const Points& points) {
    Points shuffled = points;
    if (!shuffled.empty()) shuffled.push_back(shuffled.front());
    random.shuffle(shuffled);
    const Made one(points), other(shuffled);
    CHECK(one.arrays.points == other.arrays.points);
    CHECK(one.arrays.triangles == other.arrays.triangles);
    CHECK(one.arrays.alpha == other.arrays.alpha);
    CHECK(one.arrays.pairs == other.arrays.pairs);
    CHECK(one.arrays.free_edges == other.arrays.free_edges);
  });
}

TEST_CASE("arrays can be cancelled in every phase, and those of other points are refused") {
  const Points points = random_grid(300, 40000, false, 3);
  const Made made(points);
  std::size_t calls = 0;
  rbpa::filtration_arrays(made.delaunay, points, made.filtration, [&] { return ++calls > 0; });
  REQUIRE(calls > 20);
  for (std::size_t last = 1; last <= calls; last += calls / 10) {
    std::size_t call = 0;
    CHECK_THROWS_AS(rbpa::filtration_arrays(made.delaunay, points, made.filtration, [&] { return ++call < last; }),
                    rbpa::Cancelled);
    CHECK(call == last);
  }
  const Points others = uniform(40000, 9);
  CHECK_THROWS_AS(rbpa::filtration_arrays(made.delaunay, others, made.filtration), meshops::ContractViolation);
}

TEST_SUITE_END();

#include "rbpa/plane/persistence.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshops/core/contract.h"
#include "plane/filtration/small_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/filtration/least_alpha.h"
#include "rbpa/plane/predicate/exact_integer.h"
#include "rbpa/rbpa.h"
#include "support/delaunay_arrays.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/order.h"
#include "support/random.h"
#include "support/shrink.h"

using namespace rbpa_test;
using rbpa::ComplexKind;
using rbpa::Filtration;
using rbpa::PersistencePair;
using rbpa::Point;

TEST_SUITE_BEGIN("filtration");

namespace {

using Pairs = std::vector<PersistencePair>;

Pairs persistence_of(const Points& points, ComplexKind kind) {
  const auto delaunay = delaunay_arrays(points);
  return rbpa::persistence(delaunay, points, rbpa::filtration(delaunay, points), kind);
}

std::size_t alive(const Pairs& pairs, int dimension, double alpha) {
  return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&](const PersistencePair& p) {
    return p.dimension == dimension && p.birth <= alpha && (!p.death || alpha < *p.death);
  }));
}

/// The components and holes of the alpha complex with its dangling edges, from the definition and by long integers.
class FullComplex {
 public:
  explicit FullComplex(const Points& points) : points_(points), lowest_(lowest_equal(points)) {
    triangles_ = rbpa::triangles(rbpa::rbpa(points, infinity));
    for (const auto& [a, b, c] : triangles_)
      for (const auto& [i, j] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        edges_.push_back(std::minmax(i, j));
    if (triangles_.empty()) join_on_line();
    sort_distinct(edges_);
    for (const auto& [i, j] : edges_) free_.push_back(is_free(i, j));
  }

  struct Betti {
    std::size_t components, holes;
    friend bool operator==(const Betti&, const Betti&) = default;
  };

  Betti at(double alpha) const {
    long triangles = 0, edges = 0, vertices = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> of_triangles;
    for (const auto& [a, b, c] : triangles_) {
      if (rbpa::exact_integer::compare_circumradius(points_[a], points_[b], points_[c], alpha) > 0) continue;
      ++triangles;
      for (const auto& [i, j] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        of_triangles.push_back(std::minmax(i, j));
    }
    std::vector<std::uint32_t> piece(points_.size());
    std::iota(piece.begin(), piece.end(), 0u);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const auto [i, j] = edges_[e];
      const bool there = (free_[e] && rbpa::exact_integer::compare_to_diameter(points_[i], points_[j], alpha) <= 0) ||
                         std::find(of_triangles.begin(), of_triangles.end(), std::pair(i, j)) != of_triangles.end();
      if (!there) continue;
      ++edges;
      const std::uint32_t from = piece[i], to = piece[j];
      std::replace(piece.begin(), piece.end(), from, to);
    }
    std::vector<std::uint32_t> names;
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      if (lowest_[i] == i) ++vertices, names.push_back(piece[i]);
    std::sort(names.begin(), names.end());
    const auto components = std::unique(names.begin(), names.end()) - names.begin();
    return {static_cast<std::size_t>(components), static_cast<std::size_t>(components - vertices + edges - triangles)};
  }

 private:
  bool is_free(std::uint32_t i, std::uint32_t j) const {
    return std::none_of(points_.begin(), points_.end(), [&](const Point& p) {
      return p != points_[i] && p != points_[j] && rbpa::exact_integer::dot(p, points_[i], points_[j]) < 0;
    });
  }
  void join_on_line() {
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      for (std::uint32_t j = 0; j < i; ++j)
        if (lowest_[i] == i && lowest_[j] == j && is_free(i, j)) edges_.push_back({j, i});
  }

  Points points_;
  std::vector<std::uint32_t> lowest_;
  std::vector<Triangle> triangles_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_;
  std::vector<bool> free_;
};

/// Returns every alpha at which a pair is born or dies, finite and above 0, and the adjacent doubles.
std::vector<double> telling_alphas(const Pairs& pairs) {
  std::vector<double> alphas;
  for (const PersistencePair& p : pairs)
    for (const double alpha : {p.birth, p.death.value_or(0)})
      for (const double near : {std::nextafter(alpha, 0.0), alpha, std::nextafter(alpha, infinity)})
        if (near > 0 && std::isfinite(near)) alphas.push_back(near);
  sort_distinct(alphas);
  return alphas;
}

}  // namespace

TEST_CASE("the pairs alive at a step are its components and holes") {
  std::size_t holes = 0;
  on_small_sets([&](const Points& points) {
    const auto delaunay = delaunay_arrays(points);
    const Filtration all = rbpa::filtration(delaunay, points);
    const Pairs pairs = rbpa::persistence(delaunay, points, all);
    for (const rbpa::FiltrationStep& step : all.steps) {
      INFO("alpha ", literal(step.alpha));
      CHECK(alive(pairs, 0, step.alpha) == step.components);
      CHECK(alive(pairs, 1, step.alpha) == step.holes);
      holes += step.holes;
    }
    if (!all.steps.empty()) CHECK(alive(pairs, 0, std::nextafter(all.steps.front().alpha, 0.0)) == 0);
  });
  CHECK(holes > 100);
}

TEST_CASE("the pairs of the full complex alive at an alpha are its components and holes, counted from the definition") {
  for (const SmallSet& set : small_sets()) {
    const Points& points = set.points;
    if (points.size() > 45) continue;
    CAPTURE(set.name);
    const FullComplex expected(points);
    const Pairs pairs = persistence_of(points, ComplexKind::full);
    CHECK(alive(pairs, 0, 0) == rbpa::rbpa(points, 1).distinct);
    CHECK(alive(pairs, 1, 0) == 0);
    for (const double alpha : telling_alphas(pairs)) {
      INFO("alpha ", literal(alpha));
      CHECK(FullComplex::Betti{alive(pairs, 0, alpha), alive(pairs, 1, alpha)} == expected.at(alpha));
    }
  }
}

TEST_CASE("pairs have positive persistence, are sorted, and exactly one never dies") {
  for (const ComplexKind kind : {ComplexKind::solid, ComplexKind::full})
    on_small_sets([&](const Points& points) {
      const Pairs pairs = persistence_of(points, kind);
      for (const PersistencePair& p : pairs)
        if (p.death) CHECK(p.birth < *p.death);
      CHECK(std::is_sorted(pairs.begin(), pairs.end(), [](const PersistencePair& a, const PersistencePair& b) {
        return std::tuple(a.dimension, a.birth, !a.death, a.death) <
               std::tuple(b.dimension, b.birth, !b.death, b.death);
      }));
      const auto stay = std::count_if(pairs.begin(), pairs.end(), [](const PersistencePair& p) { return !p.death; });
      const auto complex = rbpa::rbpa(points, infinity);
      CHECK(stay == (kind == ComplexKind::full ? complex.distinct > 0 : complex.mesh.n_faces() > 0));
    });
}

TEST_CASE("the younger of two components dies, and a hole dies with its last triangle") {
  // Right triangles with hypotenuses 2 and 4 and corners 10 apart: radii 1 and 2.
  const Points two = {{0, 0}, {2, 0}, {1, 1}, {12, 0}, {16, 0}, {14, 2}};
  const Pairs solid = persistence_of(two, ComplexKind::solid);
  REQUIRE(solid.size() == 2);
  CHECK(solid[0] == PersistencePair{0, 1, std::nullopt});
  CHECK(solid[1].birth == 2);
  CHECK(*solid[1].death > 5);

  // A square of side 8 whose middle is far from all points: the full complex has its boundary from 1 on.
  Points square;
  for (int i = -4; i < 4; i += 2)
    for (const Point& p : {Point{double(i), -4}, Point{4, double(i)}, Point{double(-i), 4}, Point{-4, double(-i)}})
      square.push_back(p);
  const Pairs full = persistence_of(square, ComplexKind::full);
  const auto hole = std::find_if(full.begin(), full.end(), [](const PersistencePair& p) { return p.dimension == 1; });
  REQUIRE(hole != full.end());
  CHECK(hole->birth == 1);
  CHECK(*hole->death == 4);
  CHECK(std::count_if(full.begin(), full.end(), [](const PersistencePair& p) { return p.dimension == 0; }) == 16);
}

TEST_CASE("points on a line are joined one after the other") {
  const Points line = {{6, 3}, {0, 0}, {2, 1}, {10, 5}, {2, 1}, {3, 1.5}};
  const Pairs expected = {{0, 0, rbpa::least_alpha({2, 1}, {3, 1.5})},
                          {0, 0, rbpa::least_alpha({0, 0}, {2, 1})},
                          {0, 0, rbpa::least_alpha({3, 1.5}, {6, 3})},
                          {0, 0, rbpa::least_alpha({6, 3}, {10, 5})},
                          {0, 0, std::nullopt}};
  CHECK(persistence_of(line, ComplexKind::full) == expected);
  CHECK(persistence_of(line, ComplexKind::solid).empty());
}

TEST_CASE("the order of the points, and duplicates, do not change the pairs") {
  Random random(7);
  for (const ComplexKind kind : {ComplexKind::solid, ComplexKind::full})
    on_small_sets([&](const Points& points) {
      Points shuffled = points;
      if (!points.empty()) shuffled.push_back(points.front());
      random.shuffle(shuffled);
      CHECK(persistence_of(points, kind) == persistence_of(shuffled, kind));
    });
}

TEST_CASE("false from go_on cancels in every phase, and true changes nothing") {
  Points line;
  for (int i = 0; i < 20000; ++i) line.push_back({double(i * 7919 % 20000), 0});
  for (const auto& [points, kind] :
       {std::pair(random_grid(300, 40000, false, 3), ComplexKind::solid),
        std::pair(random_grid(300, 40000, false, 3), ComplexKind::full), std::pair(line, ComplexKind::full)}) {
    const auto delaunay = delaunay_arrays(points);
    const Filtration all = rbpa::filtration(delaunay, points);
    std::size_t calls = 0;
    const Pairs whole = rbpa::persistence(delaunay, points, all, kind, [&] { return ++calls > 0; });
    CHECK(whole == rbpa::persistence(delaunay, points, all, kind));
    REQUIRE(calls > 20);
    for (std::size_t last = 1; last <= calls; last += calls / 10) {
      std::size_t call = 0;
      CHECK_THROWS_AS(rbpa::persistence(delaunay, points, all, kind, [&] { return ++call < last; }), rbpa::Cancelled);
      CHECK(call == last);
    }
  }
}

TEST_CASE("a filtration of other points is refused") {
  const Points points = uniform(30, 9), others = uniform(31, 9);
  const auto delaunay = delaunay_arrays(points), other = delaunay_arrays(others);
  const Filtration mine = rbpa::filtration(delaunay, points), theirs = rbpa::filtration(other, others);
  CHECK_THROWS_AS(rbpa::persistence(delaunay, points, theirs), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::persistence(delaunay, others, mine), meshops::ContractViolation);
}

TEST_SUITE_END();

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/contract.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/topology.h"
#include "rbpa/rbpa.h"
#include "support/arguments.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/sets.h"
#include "support/spacing.h"

using namespace rbpa_test;
using rbpa::AlphaComplex;
using rbpa::ComplexCounts;
using rbpa::ComplexKind;

TEST_SUITE_BEGIN("arrays");

namespace {

/// Sets of numbers, by repainting.
class Paint {
 public:
  explicit Paint(std::size_t size) : color_(size) { std::iota(color_.begin(), color_.end(), 0u); }
  void join(std::size_t a, std::size_t b) {
    const std::uint32_t from = color_[a], to = color_[b];
    std::replace(color_.begin(), color_.end(), from, to);
  }
  std::size_t colors() const { return std::set(color_.begin(), color_.end()).size(); }

 private:
  std::vector<std::uint32_t> color_;
};

/// Counts by the definitions: connected parts get one color, and the number of holes follows from Euler's formula.
ComplexCounts by_definition(const AlphaComplex& complex, ComplexKind kind) {
  std::set<std::uint32_t> vertices;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> triangles_at;
  for (std::size_t t = 0; t < complex.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = complex.triangles[t][k], b = complex.triangles[t][(k + 1) % 3];
      triangles_at[std::minmax(a, b)].push_back(t);
      vertices.insert(a);
    }
  Paint solid(complex.triangles.size());
  for (const auto& [edge, at] : triangles_at)
    if (at.size() == 2) solid.join(at[0], at[1]);
  for (const auto& [a, b] : complex.edges) {
    triangles_at[{a, b}];
    vertices.insert({a, b});
  }
  if (kind == ComplexKind::full) vertices.insert(complex.points.begin(), complex.points.end());
  const std::vector<std::uint32_t> sorted(vertices.begin(), vertices.end());
  const auto number = [&](std::uint32_t v) {
    return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin());
  };
  Paint space(sorted.size());
  for (const auto& [edge, at] : triangles_at) space.join(number(edge.first), number(edge.second));
  ComplexCounts counts{.points_covered = sorted.size() - (kind == ComplexKind::full ? complex.points.size() : 0),
                       .edges = triangles_at.size(),
                       .triangles = complex.triangles.size(),
                       .solid_components = solid.colors(),
                       .components = space.colors()};
  counts.holes = counts.components + counts.edges - sorted.size() - counts.triangles;
  return counts;
}

void check_all_ways(const Points& points, double alpha) {
  CAPTURE(alpha);
  const rbpa::SolidAlphaComplex mesh = rbpa::rbpa(points, alpha);
  for (const unsigned threads : {1u, 2u}) {
    const AlphaComplex by_neighbors = rbpa::alpha_complex(points, alpha, {.neighbors = true, .threads = threads}),
                       by_boundary = rbpa::alpha_complex(points, alpha, {.boundary = true, .threads = threads}),
                       by_both = rbpa::alpha_complex(points, alpha,
                                                     {.neighbors = true, .boundary = true, .threads = threads});
    CHECK(by_boundary.neighbors.empty());
    CHECK(by_boundary.triangles == by_both.triangles);
    CHECK(by_boundary.boundary == by_both.boundary);
    CHECK(rbpa::count(points, by_neighbors) == rbpa::count(mesh));
    CHECK(rbpa::count(points, by_boundary) == rbpa::count(mesh));
  }
}

}  // namespace

TEST_CASE("counts of arrays equal those of the mesh, with pinches, by boundary or by neighbors") {
  for (const NamedSet& set : generated_sets()) {
    CAPTURE(set.name);
    const Points points = set.make();
    for (const double alpha : set.alphas) check_all_ways(points, alpha);
    for (const double spacings : {0.55, 0.8, 2.0})
      if (mean_spacing(points) > 0) check_all_ways(points, spacings * mean_spacing(points));
    check_all_ways(points, infinity);
  }
}

TEST_CASE("counts of full and solid complexes on small sets follow the definitions") {
  Random random(71);
  std::size_t edges = 0, holes = 0, pinched = 0;
  for (int i = 0; i < trials(4000); ++i) {
    Points points;
    const bool on_grid = random.chance(0.7);
    const int side = random.integer(2, 7);
    for (std::size_t n = 1 + random.below(40); n > 0; --n)
      points.push_back(on_grid ? rbpa::Point{static_cast<double>(random.integer(0, side)),
                                             static_cast<double>(random.integer(0, side))}
                               : rbpa::Point{random.between(0, side), random.between(0, side)});
    const double alpha = random.between(0.4, 1.3);
    for (const ComplexKind kind : {ComplexKind::solid, ComplexKind::full}) {
      const AlphaComplex complex = rbpa::alpha_complex(points, alpha, {.complex = kind, .boundary = true});
      const ComplexCounts found = rbpa::count(points, complex, kind);
      ComplexCounts expected = by_definition(complex, kind);
      expected.boundary_curves = rbpa::count(rbpa::rbpa(points, alpha)).boundary_curves;
      REQUIRE(found == expected);
      edges += complex.edges.size();
      holes += found.holes;
      pinched += found.components < found.solid_components;
    }
  }
  CHECK(edges > 1000);
  CHECK(holes > 100);
  CHECK(pinched > 100);
}

TEST_CASE("the full complex of points on a line is a path of edges") {
  const Points points = {{0, 0}, {1, 1}, {2, 2}, {7, 7}, {8, 8}, {20, 20}};
  const AlphaComplex path = rbpa::alpha_complex(points, 1, {.complex = ComplexKind::full, .boundary = true});
  CHECK(rbpa::count(points, path, ComplexKind::full) ==
        ComplexCounts{.points_covered = 5, .edges = 3, .triangles = 0, .components = 3});
  CHECK(rbpa::count(points, rbpa::alpha_complex(points, infinity, {.boundary = true})) == ComplexCounts{});
  CHECK(rbpa::count({}, {}) == ComplexCounts{});
}

TEST_CASE("arrays without a boundary, or with an open one, are refused; false from go_on cancels") {
  const Points points = uniform(3000, 72);
  AlphaComplex complex = rbpa::alpha_complex(points, mean_spacing(points), {.boundary = true});
  REQUIRE(!complex.boundary.empty());
  std::size_t calls = 0;
  CHECK_THROWS_AS(rbpa::count(points, rbpa::alpha_complex(points, infinity)), meshops::ContractViolation);
  const Points many = random_grid(300, 60000, false, 73);
  const AlphaComplex torn = rbpa::alpha_complex(many, 0.8, {.boundary = true});
  CHECK_THROWS_AS(rbpa::count(many, torn, ComplexKind::solid, [&] { return ++calls < 2; }), rbpa::Cancelled);
  complex.boundary.pop_back();
  CHECK_THROWS_AS(rbpa::count(points, complex), meshops::ContractViolation);
}

TEST_SUITE_END();

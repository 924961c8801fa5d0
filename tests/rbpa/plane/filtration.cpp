#include "rbpa/plane/filtration.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "meshops/core/contract.h"
#include "plane/filtration/small_sets.h"
#include "rbpa/base/error.h"
#include "rbpa/plane/topology.h"
#include "rbpa/rbpa.h"
#include "support/delaunay_arrays.h"
#include "support/generate.h"
#include "support/infinity.h"
#include "support/random.h"
#include "support/shrink.h"

using namespace rbpa_test;
using rbpa::Filtration;
using rbpa::FiltrationStep;
using rbpa::Point;

TEST_SUITE_BEGIN("filtration");

namespace {

Filtration filtration_of(const Points& points) { return rbpa::filtration(delaunay_arrays(points), points); }

/// Returns the step that must be counted at this alpha, from the complex built anew.
FiltrationStep recounted(const Points& points, double alpha, double area) {
  const rbpa::ComplexCounts counts = rbpa::count(rbpa::rbpa(points, alpha));
  return {alpha, counts.triangles, counts.solid_components, counts.components, counts.holes, counts.points_covered,
          area};
}

double area_of(const Points& points, const std::vector<Triangle>& triangles) {
  using Wide = long double;
  const auto cross = [](const Point& a, const Point& b, const Point& c) {
    return (Wide(b.x) - a.x) * (Wide(c.y) - a.y) - (Wide(b.y) - a.y) * (Wide(c.x) - a.x);
  };
  Wide sum = 0;
  for (const auto& [a, b, c] : triangles) sum += cross(points[a], points[b], points[c]) / 2;
  return static_cast<double>(sum);
}

}  // namespace

TEST_CASE("every step counts the complex at its alpha, and the next lower double still has the complex before") {
  on_small_sets([&](const Points& points) {
    const Filtration all = filtration_of(points);
    std::size_t before = 0;
    for (const FiltrationStep& step : all.steps) {
      INFO("alpha ", literal(step.alpha));
      CHECK(step == recounted(points, step.alpha, step.area));
      if (const double below = std::nextafter(step.alpha, 0.0); below > 0)
        CHECK(rbpa::rbpa(points, below).mesh.n_faces() == before);
      before = step.triangles;
    }
    CHECK(before == rbpa::rbpa(points, infinity).mesh.n_faces());
  });
}

TEST_CASE("steps ascend, and end with the Delaunay triangulation: one disc over all points") {
  on_small_sets([&](const Points& points) {
    const Filtration all = filtration_of(points);
    CHECK(std::adjacent_find(all.steps.begin(), all.steps.end(), [](const auto& a, const auto& b) {
            return a.alpha >= b.alpha || a.triangles >= b.triangles || a.covered > b.covered || a.area > b.area;
          }) == all.steps.end());
    if (all.steps.empty()) return;
    CHECK(all.steps.front().alpha > 0);
    const FiltrationStep& last = all.steps.back();
    CHECK(last.covered == all.distinct);
    CHECK(last.solid_components == 1);
    CHECK(last.components == 1);
    CHECK(last.holes == 0);
  });
}

TEST_CASE("a triangle is in the complex from its triangle_alpha on") {
  on_small_sets([&](const Points& points) {
    const auto delaunay = delaunay_arrays(points);
    const Filtration all = rbpa::filtration(delaunay, points);
    REQUIRE(all.triangle_alpha.size() == delaunay.triangles.size());
    for (const FiltrationStep& step : all.steps) {
      const auto in = std::count_if(all.triangle_alpha.begin(), all.triangle_alpha.end(),
                                    [&](double alpha) { return alpha <= step.alpha; });
      CHECK(static_cast<std::size_t>(in) == step.triangles);
    }
  });
}

TEST_CASE("complex_at() a radius is the complex of another triangulation") {
  on_small_sets([&](const Points& points) {
    const rbpa::Delaunay delaunay(points, {.neighbors = true, .boundary = true});
    const Filtration all = rbpa::filtration(delaunay);
    std::vector<double> alphas = {1e-300, infinity};
    for (const FiltrationStep& step : all.steps) {
      if (step.alpha > 0 && std::isfinite(step.alpha)) alphas.push_back(step.alpha);
      if (const double below = std::nextafter(step.alpha, 0.0); below > 0) alphas.push_back(below);
    }
    for (const double alpha : alphas) {
      INFO("alpha ", literal(alpha));
      const rbpa::AlphaComplex at = rbpa::complex_at(delaunay, all, alpha),
                               anew = rbpa::alpha_complex(points, alpha, {.neighbors = true});
      CHECK(at.triangles == anew.triangles);
      CHECK(at.neighbors == anew.neighbors);
      CHECK(at.isolated == anew.isolated);
      CHECK(at.boundary.empty());
      CHECK(at.duplicates == anew.duplicates);
      CHECK(at.distinct == anew.distinct);
    }
    CHECK_THROWS_AS(rbpa::complex_at(delaunay, all, 0), meshops::ContractViolation);
    if (!all.steps.empty()) CHECK_THROWS_AS(rbpa::complex_at(delaunay, {}, 1), meshops::ContractViolation);
  });
}

TEST_CASE("the area is the sum of the triangles' areas") {
  for (const Points& points : {uniform(80, 3), random_grid(9, 50, true, 4), clusters(5, 5)})
    for (const FiltrationStep& step : filtration_of(points).steps)
      CHECK(step.area ==
            doctest::Approx(area_of(points, rbpa::triangles(rbpa::rbpa(points, step.alpha)))).epsilon(1e-12));
  CHECK(filtration_of(perfect_grid(11, 0.5)).steps.back().area == 25);
}

TEST_CASE("equal radii are one step") {
  const Filtration grid = filtration_of(perfect_grid(20, 1));
  REQUIRE(grid.steps.size() == 1);
  CHECK(grid.steps[0] == FiltrationStep{0.70710678118654757, 722, 1, 1, 0, 400, 361});
  const Filtration rectangles = filtration_of(rectangles_of_circumradius_5(8));
  REQUIRE(rectangles.steps.size() == 1);
  CHECK(rectangles.steps[0].alpha == 5);
}

TEST_CASE("points without a triangle have no steps") {
  for (const Points& points :
       {Points{}, Points{{1, 2}}, Points{{1, 2}, {3, 4}}, Points(5, {1, 2}), collinear_run(20, 3, 1, 6)}) {
    const Filtration none = filtration_of(points);
    CHECK(none.steps.empty());
    CHECK(none.distinct == rbpa::rbpa(points, 1).distinct);
    CHECK_FALSE(rbpa::smallest_covering(none));
    CHECK_FALSE(rbpa::smallest_covering(none, 1));
  }
}

TEST_CASE("the order of the points, and duplicates, do not matter") {
  Random random(7);
  on_small_sets([&](const Points& points) {
    Points shuffled = points;
    if (!points.empty()) shuffled.push_back(points.front());
    random.shuffle(shuffled);
    CHECK(filtration_of(points).steps == filtration_of(shuffled).steps);
  });
}

TEST_CASE("a power of two scales every alpha and changes nothing else") {
  const Points points = uniform(60, 8);
  const Filtration one = filtration_of(points);
  for (const int exponent : {-900, -3, 1, 900}) {
    Filtration other = filtration_of(scaled(points, exponent));
    REQUIRE(other.steps.size() == one.steps.size());
    for (std::size_t i = 0; i < one.steps.size(); ++i) {
      CHECK(other.steps[i].alpha == std::ldexp(one.steps[i].alpha, exponent));
      other.steps[i].alpha = one.steps[i].alpha;
      other.steps[i].area = one.steps[i].area;
      CHECK(other.steps[i] == one.steps[i]);
    }
  }
}

TEST_CASE("a radius above every finite double is infinity, and rbpa at infinity has its triangle") {
  const Points points = {{-1e308, 0}, {0, -5e-324}, {1e308, 0}, {0, -1e308}};
  const Filtration all = filtration_of(points);
  REQUIRE(all.steps.size() >= 2);
  CHECK(all.steps.back().alpha == infinity);
  CHECK(rbpa::smallest_covering(all) == all.steps.front().alpha);
}

TEST_CASE("smallest_covering is the least alpha at which all points are covered by few enough solid components") {
  std::size_t ups_and_downs = 0;
  on_small_sets([&](const Points& points) {
    const Filtration all = filtration_of(points);
    for (std::size_t most = 0; most <= 6; ++most) {
      CAPTURE(most);
      // Builds the complex anew at each radius; between two radii it is that of the lower one.
      std::optional<double> expected, expected_any;
      bool again = false;
      for (const FiltrationStep& step : all.steps) {
        const auto complex = rbpa::rbpa(points, step.alpha);
        if (!complex.isolated.empty()) continue;
        if (!expected_any) expected_any = step.alpha;
        const bool few = rbpa::count(complex).solid_components <= most;
        if (few && !expected) expected = step.alpha;
        if (!few && expected) again = true;
      }
      ups_and_downs += again;
      CHECK(rbpa::smallest_covering(all, most) == expected);
      CHECK(rbpa::smallest_covering(all) == expected_any);
    }
  });
  CHECK(ups_and_downs > 0);
}

TEST_CASE("false from go_on cancels in every phase, and true changes nothing") {
  const Points points = random_grid(300, 40000, false, 3);
  const auto delaunay = delaunay_arrays(points);
  std::size_t calls = 0;
  const Filtration whole = rbpa::filtration(delaunay, points, [&] { return ++calls > 0; });
  CHECK(whole.steps == rbpa::filtration(delaunay, points).steps);
  REQUIRE(calls > 20);
  for (std::size_t last = 1; last <= calls; last += calls / 10) {
    std::size_t call = 0;
    CHECK_THROWS_AS(rbpa::filtration(delaunay, points, [&] { return ++call < last; }), rbpa::Cancelled);
    CHECK(call == last);
  }
}

TEST_CASE("a triangulation of other points, or not of all triangles, is refused") {
  const Points points = uniform(30, 9);
  Points exchanged = points;
  std::swap(exchanged[3], exchanged[17]);  // triangles turn right
  const auto delaunay = delaunay_arrays(points);
  CHECK_THROWS_AS(rbpa::filtration(delaunay, exchanged), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::filtration(delaunay, std::span(points).first(10)), meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::filtration(rbpa::alpha_complex(points, 0.5, {.neighbors = true}), points),
                  meshops::ContractViolation);
  CHECK_THROWS_AS(rbpa::filtration(rbpa::alpha_complex(points, infinity), points), meshops::ContractViolation);
  auto unlinked = delaunay;
  std::swap(unlinked.neighbors[3][0], unlinked.neighbors[3][1]);
  CHECK_THROWS_AS(rbpa::filtration(unlinked, points), meshops::ContractViolation);
}

TEST_SUITE_END();

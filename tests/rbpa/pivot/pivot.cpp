#include "rbpa/pivot/pivot.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "rbpa/predicate/magnitude.h"
#include "support/exact.h"
#include "support/generate.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::Pivot;
using rbpa::Point;
using rbpa::PointGrid;
using rbpa::Radius;

TEST_SUITE_BEGIN("pivot");

namespace {

using Site = std::uint32_t;
using Points = std::vector<Point>;

/// The winner among all points left of a→b, whatever its circumradius.
std::optional<Site> winner(const Points& points, Site a, Site b) {
  std::optional<Site> best;
  for (Site i = 0; i < points.size(); ++i)
    if (exact::orientation(points[a], points[b], points[i]) > 0 &&
        (!best || exact::in_perturbed_circle(points[a], points[b], points[*best], points[i]) > 0))
      best = i;
  return best;
}

double some_radius(const Points& points, Random& random) {
  if (random.chance(0.2)) return std::numeric_limits<double>::infinity();
  const Point p = points[random.below(points.size())], q = points[random.below(points.size())];
  const double d = std::hypot(p.x / 4 - q.x / 4, p.y / 4 - q.y / 4);
  return d > 0 ? std::ldexp(d, random.integer(-1, 5)) : 1.0;
}

template <typename Real>
void check_all_pairs(const Points& input, const std::vector<double>& radii, Random& random) {
  const PointGrid<Real> grid(input);
  const Points points(grid.points().begin(), grid.points().begin() + static_cast<std::ptrdiff_t>(grid.input_index().size()));
  const auto count = static_cast<Site>(points.size());
  const Real unit = std::is_same_v<Real, double> ? std::ldexp(Real(1), rbpa::magnitude(input).lowest) : Real(0);
  std::vector<std::optional<Site>> best(std::size_t(count) * count);
  for (Site a = 0; a < count; ++a)
    for (Site b = 0; b < count; ++b)
      if (a != b) best[a * count + b] = winner(points, a, b);

  for (const double alpha : radii) {
    CAPTURE(alpha);
    const Radius radius = std::isinf(alpha) ? Radius() : Radius(alpha);
    const Pivot<Real> pivot(grid, radius, unit);
    for (Site a = 0; a < count; ++a)
      for (Site b = 0; b < count; ++b) {
        if (a == b) continue;
        CAPTURE(a);
        CAPTURE(b);
        std::optional<Site> expected = best[a * count + b];
        if (expected && !std::isinf(alpha) &&
            exact::compare_circumradius(points[a], points[b], points[*expected], alpha) > 0)
          expected.reset();
        CHECK(pivot(a, b) == expected);
        const auto any = [&] { return static_cast<Site>(random.below(count)); };
        CHECK(pivot(a, b, {any()}) == expected);
        CHECK(pivot(a, b, {any(), any()}) == expected);
        CHECK(pivot(a, b, {a, b}) == expected);
        if (expected) CHECK(pivot(a, b, {*expected, *expected}) == expected);
      }
  }
}

template <typename Real>
void check_kind(Kind kind, int sets, std::size_t count, Random& random) {
  CAPTURE(name(kind));
  for (int set = 0; set < sets; ++set) {
    CAPTURE(set);
    Points points(count);
    fill(points, kind, random);
    std::vector<double> radii;
    for (int i = 0; i < 4; ++i) radii.push_back(some_radius(points, random));
    radii.push_back(65);
    check_all_pairs<Real>(points, radii, random);
  }
}

}  // namespace

TEST_CASE("the pivot is the winner among all points, with any hints: kinds of points") {
  Random random(51);
  for (const Kind kind : kinds_that_fit_double) {
    check_kind<double>(kind, 3, 11, random);
    check_kind<long double>(kind, 1, 9, random);
  }
}

TEST_CASE("the pivot is the winner among all points: exponents that leave the range of double") {
  Random random(52);
  check_kind<long double>(Kind::extreme, 8, 8, random);
}

TEST_CASE("the pivot is the winner among all points: more points than a cell holds") {
  Random random(53);
  const double infinity = std::numeric_limits<double>::infinity();
  check_all_pairs<double>(perfect_grid(5, 1), {0.7071067811865475, 0.7071067811865476, 1.5, 40, infinity}, random);
  check_all_pairs<double>(clusters(3, 5), {1e-8, 1e-3, 1, infinity}, random);
  check_all_pairs<double>(rounded_concentric(12), {0.5, 1, 2, infinity}, random);
}

TEST_CASE("a point whose circle has exactly the radius is reached, one step less and it is not") {
  // On circles of radius 65 · 2^e around anywhere, through points found in every direction.
  Random random(54);
  for (int trial = 0; trial < 300; ++trial) {
    Points points(3);
    fill(points, Kind::on_circle, random);
    const PointGrid<double> grid(points);
    if (grid.input_index().size() < 3) continue;
    const Site b = exact::orientation(grid.points()[0], grid.points()[1], grid.points()[2]) > 0 ? 1 : 2;
    int exponent = -60;  // the scale that fill() took
    while (exponent < 60 && exact::compare_circumradius(points[0], points[1], points[2], std::ldexp(65.0, exponent)) > 0)
      ++exponent;
    const double alpha = std::ldexp(65.0, exponent);
    CHECK(exact::compare_circumradius(points[0], points[1], points[2], alpha) == 0);
    CHECK(Pivot<double>(grid, Radius(alpha), 0.0)(0, b) == 3 - b);
    CHECK(Pivot<double>(grid, Radius(std::nextafter(alpha, 0.0)), 0.0)(0, b) == std::nullopt);
  }
}

TEST_SUITE_END();

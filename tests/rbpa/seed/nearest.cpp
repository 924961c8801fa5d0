#include "rbpa/seed/nearest.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "rbpa/predicate/magnitude.h"
#include "support/exact.h"
#include "support/generate.h"
#include "support/samples.h"

using namespace rbpa_test;
using rbpa::Point;
using rbpa::PointGrid;
using rbpa::Radius;

TEST_SUITE_BEGIN("seed");

namespace {

template <typename Real>
void check(const Points& input, const std::vector<double>& radii) {
  const PointGrid<Real> grid(input);
  const auto count = static_cast<std::uint32_t>(grid.input_index().size());
  for (std::uint32_t v = 0; v < count; ++v) {
    const Point centre = grid.points()[v];
    std::optional<std::uint32_t> best;
    for (std::uint32_t i = 0; i < count; ++i)
      if (i != v && (!best || exact::compare_distances(centre, grid.points()[i], grid.points()[*best]) < 0)) best = i;
    for (const double alpha : radii) {
      CAPTURE(alpha);
      const Radius radius = std::isinf(alpha) ? Radius() : Radius(alpha);
      const auto found = rbpa::nearest(grid, radius, v);
      const bool expected =
          best && (std::isinf(alpha) || exact::compare_to_diameter(centre, grid.points()[*best], alpha) <= 0);
      REQUIRE(found.has_value() == expected);
      if (found) CHECK(*found != v);
      if (found) CHECK(exact::compare_distances(centre, grid.points()[*found], grid.points()[*best]) == 0);
    }
  }
}

}  // namespace

TEST_CASE_TEMPLATE("nearest() finds a nearest point, unless it is farther than 2 alpha", Real, double, long double) {
  check<Real>(perfect_grid(7, 1), {0.25, 0.5, std::nextafter(0.5, 0.0), 1, INFINITY});
  check<Real>(uniform(80, 1), {0.1, 0.2, 0.4, 1, 1e9, INFINITY});
  check<Real>(clusters(7, 2), {1e-10, 1e-6, 1e-2, INFINITY});
  check<Real>(pairs_at_distance_2(12, 3), {std::nextafter(1.0, 0.0), 1, std::nextafter(1.0, 2.0)});
  check<Real>(moved(scaled(uniform(50, 4), -10), 1e6, -1e6), {1e-4, 1e-3, 1});
  check<Real>({{1, 2}, {1, 2}}, {1, INFINITY});
  check<Real>({{1, 2}, {1, 4}}, {0.5, 1, INFINITY});
  Random random(61);
  for (const Kind kind : kinds_that_fit_double) {
    Points points(20);
    fill(points, kind, random);
    check<Real>(points, {0x1p-152, 1e-3, 1, 1e5, 0x1p+754, INFINITY});
  }
}

TEST_CASE("a nearer point in a cell not looked at yet is not passed over") {
  Random random(62);
  for (int trial = 0; trial < 1500; ++trial) {
    Points points(static_cast<std::size_t>(random.integer(3, 9)));
    for (Point& p : points) p = {random.between(-1, 1), random.between(-1, 1)};
    check<double>(points, {INFINITY});
  }
}

TEST_CASE("nearest() knows no limit of exponents") {
  check<long double>(mixed_exponents(8, 1), {1e-300, 1, 1e300, INFINITY});
  check<long double>(denormals(6, 20, 2), {5e-324, 1e-323, 1, 1.7e308, INFINITY});
  check<long double>(far_and_tiny(6, 3), {1e-300, 1e300, INFINITY});
}

TEST_SUITE_END();

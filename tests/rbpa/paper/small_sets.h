// What: sets of few points on which the paper's method has hard decisions, and the right result by definition.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "rbpa/plane/complex.h"
#include "rbpa/plane/predicate/radius.h"
#include "support/arguments.h"
#include "support/exact.h"
#include "support/order.h"
#include "support/random.h"
#include "support/samples.h"
#include "support/triangle.h"

namespace rbpa_test {

inline rbpa::Radius radius_of(double alpha) { return std::isinf(alpha) ? rbpa::Radius() : rbpa::Radius(alpha); }

/// Returns the points without duplicates, in a random order.
inline Points distinct(Points points, Random& random) {
  sort_distinct(points);
  random.shuffle(points);
  return points;
}

inline std::vector<std::uint32_t> all_sites(const Points& points) {
  std::vector<std::uint32_t> sites(points.size());
  std::iota(sites.begin(), sites.end(), std::uint32_t{0});
  return sites;
}

/// Returns the triangles that turn left, whose circle is at most as large as the ball and contains no point. Requires:
/// distinct points.
inline std::vector<Triangle> complex_by_definition(const Points& points, double alpha) {
  const auto count = static_cast<std::uint32_t>(points.size());
  std::vector<Triangle> result;
  for (std::uint32_t a = 0; a < count; ++a)
    for (std::uint32_t b = a + 1; b < count; ++b)
      for (std::uint32_t c = a + 1; c < count; ++c) {
        if (c == b || exact::orientation(points[a], points[b], points[c]) <= 0) continue;
        if (!std::isinf(alpha) && exact::compare_circumradius(points[a], points[b], points[c], alpha) > 0) continue;
        bool is_empty = true;
        for (std::uint32_t q = 0; is_empty && q < count; ++q)
          is_empty =
              q == a || q == b || q == c || exact::in_perturbed_circle(points[a], points[b], points[c], points[q]) <= 0;
        if (is_empty) result.push_back({a, b, c});
      }
  return canonical(std::move(result));
}

/// Returns a radius of the order of the distances between the points, or the radius of a tie.
inline double some_radius(const Points& points, Kind kind, Random& random) {
  if (random.chance(0.15)) return std::numeric_limits<double>::infinity();
  if (kind == Kind::small_grid && random.chance(0.7)) {
    const double ties[] = {0.5, 1, 1.25, 1.5, 2, 2.5, 3};
    return ties[random.below(7)];
  }
  if (kind == Kind::on_circle && random.chance(0.5)) return std::ldexp(65.0, random.integer(-60, 60));
  const rbpa::Point p = points[random.below(points.size())], q = points[random.below(points.size())];
  const double d = std::hypot(p.x / 4 - q.x / 4, p.y / 4 - q.y / 4);
  return std::max(std::ldexp(d, random.integer(-1, 5)), std::numeric_limits<double>::denorm_min());
}

/// Returns whether the smallest leaf is as small as the steps between doubles, so that its corners depend on the
/// arithmetic.
inline bool is_lost_in_rounding(double least_radius, const Points& points) {
  double largest = 0;
  for (const rbpa::Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return least_radius < 4 * std::numeric_limits<double>::epsilon() * largest;
}

/// Calls check(points, alpha, random) for sets of up to `most` distinct points of every kind, not all on a line.
template <typename Check>
void for_small_sets_of_every_kind(std::uint64_t seed, int sets, int most, Check check) {
  Random random(seed);
  const auto some = [&](Kind kind) {
    for (int set = 0; set < trials(sets); ++set) {
      Points points(static_cast<std::size_t>(random.integer(3, most)));
      fill(points, kind, random);
      points = distinct(std::move(points), random);
      bool is_flat = true;
      for (std::size_t i = 2; i < points.size(); ++i)
        is_flat = is_flat && exact::orientation(points[0], points[1], points[i]) == 0;
      if (!is_flat) check(points, some_radius(points, kind, random), random);
    }
  };
  for (const Kind kind : kinds_that_fit_double) some(kind);
  some(Kind::extreme);
}

}  // namespace rbpa_test

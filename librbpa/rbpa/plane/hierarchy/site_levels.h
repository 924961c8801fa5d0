// What: the level of a triangle on sites, computed in the scale of the window of doubles if the triangle lies in the
//       window, otherwise in the scale of the input.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "meshops/patch/site.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/hierarchy/ladder.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {

/// Returns a lower bound of the circumradius of (a, b, c), up to rounding. The bound is for scheduling only; no
/// decision depends on it. The bound is at least half of the circumradius unless the corners are so near a line that
/// rounding hides their area.
/// Requires: coordinates in the range of `Real` (fits_double() for double); corners that are not all equal.
template <typename Real>
Real circumradius(const Point& a, const Point& b, const Point& c) {
  using P = Predicates<Real>;
  const auto ab = P::from(a, b), bc = P::from(b, c), ca = P::from(c, a);
  const Real max_area = std::abs(P::cross(ab, ca)) + 8 * P::unit_roundoff * P::cross_magnitude(ab, ca);
  return std::sqrt(P::dot(ab, ab) * P::dot(bc, bc) * P::dot(ca, ca)) / (2 * max_area);
}

/// Returns the first level whose radius admits the triangle (a, b, c). `SomeLadder` is Ladder or ScaledLadder; the
/// corners are in the scale of `ladder`.
/// Requires: the last level admits the triangle.
template <typename Real, typename SomeLadder>
int first_level(const Point& a, const Point& b, const Point& c, const SomeLadder& ladder) {
  if (ladder.radius(0).template admits<Real>(a, b, c)) return 0;
  int level = std::clamp(ladder.first_reaching(circumradius<Real>(a, b, c)), 1, ladder.end());
  while (!ladder.is_last(level) && !ladder.radius(level).template admits<Real>(a, b, c)) ++level;
  return level;
}

class SiteLevels {
 public:
  /// Keeps references to both arguments. Cost: linear in the levels.
  SiteLevels(const Sites& sites, const Ladder& ladder)
      : sites_(sites), ladder_(ladder), scaled_ladder_(ladder, sites.window()) {}

  /// Returns the first level whose radius admits the triangle. Requires: the last level's radius admits the triangle.
  int of(const std::array<meshops::Site, 3>& t) const {
    const std::span<const Point> points = sites_.grid().points();
    const std::size_t in_window = points.size();
    if (t[0] < in_window && t[1] < in_window && t[2] < in_window)
      return first_level<double>(points[t[0]], points[t[1]], points[t[2]], scaled_ladder_);
    return first_level<long double>(sites_.at(t[0]), sites_.at(t[1]), sites_.at(t[2]), ladder_);
  }

 private:
  const Sites& sites_;
  const Ladder& ladder_;
  ScaledLadder scaled_ladder_;
};

}  // namespace rbpa

// What: a rounded lower bound of the circumradius, for scheduling only: no decision depends on it.
#pragma once

#include <cmath>

#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {

/// Returns a lower bound of the circumradius of (a, b, c), up to rounding; at least half of the circumradius unless the
/// corners are so near a line that rounding hides their area.
/// Requires: coordinates in the range of `Real` (fits_double() for double); corners that are not all equal.
template <typename Real>
Real circumradius(const Point& a, const Point& b, const Point& c) {
  using P = Predicates<Real>;
  const auto ab = P::from(a, b), bc = P::from(b, c), ca = P::from(c, a);
  const Real max_area = std::abs(P::cross(ab, ca)) + 8 * P::unit_roundoff * P::cross_magnitude(ab, ca);
  return std::sqrt(P::dot(ab, ab) * P::dot(bc, bc) * P::dot(ca, ca)) / (2 * max_area);
}

}  // namespace rbpa

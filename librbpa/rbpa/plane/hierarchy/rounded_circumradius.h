// What: the circumradius in rounded numbers, for scheduling only: no decision depends on it.
#pragma once

#include <cmath>

#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {

/// Returns at most the circumradius of (a, b, c), up to the last digits, and at least half of it, unless the corners
/// are so near a line that rounding hides their area.
template <typename Real>
Real circumradius(const Point& a, const Point& b, const Point& c) {
  using P = Predicates<Real>;
  const auto ab = P::from(a, b), bc = P::from(b, c), ca = P::from(c, a);
  const Real max_area = std::abs(P::cross(ab, ca)) + 8 * P::unit_roundoff * P::cross_magnitude(ab, ca);
  return std::sqrt(P::dot(ab, ab) * P::dot(bc, bc) * P::dot(ca, ca)) / (2 * max_area);
}

}  // namespace rbpa

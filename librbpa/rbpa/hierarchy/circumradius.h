// What: the circumradius in rounded numbers, for scheduling only: no decision depends on it.
#pragma once

#include <cmath>

#include "rbpa/predicate/predicates.h"

namespace rbpa {

/// Within a millionth of the circumradius of (a, b, c), or 0 when they are too near a line to say.
template <typename Real>
Real circumradius(const Point& a, const Point& b, const Point& c) {
  using P = Predicates<Real>;
  const auto ab = P::from(a, b), bc = P::from(b, c), ca = P::from(c, a);
  const Real area = std::abs(P::cross(ab, ca));
  if (area < Real(1e8) * P::unit * P::cross_size(ab, ca)) return 0;
  return std::sqrt(P::dot(ab, ab)) * std::sqrt(P::dot(bc, bc)) * (std::sqrt(P::dot(ca, ca)) / (2 * area));
}

}  // namespace rbpa

// What: the exact predicates of the plane on any finite coordinates, in double if all three or four points allow it.
// Why:  cases that a filter leaves open are decided by expansions in double, but by integers of any length in long
//       double, which takes ten times as long. In fillings such cases are frequent, as many points lie on one edge.
#pragma once

#include <cmath>
#include <limits>

#include "rbpa/base/exact/magnitude.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {

/// Returns whether a coordinate is 0, or its absolute value is at least 2^−97 and below 2^150. All 53 bits of such a
/// coordinate are within the bounds of base/exact/magnitude.h.
inline bool fits_double(double x) {
  constexpr double least = 0x1p-97, most = 0x1p150;
  static_assert(least_in_double <= -97 - 52 && largest_in_double >= 150);
  return x == 0 || (std::abs(x) >= least && std::abs(x) < most);
}
inline bool fits_double(const Point& p) { return fits_double(p.x) && fits_double(p.y); }

inline int plane_orientation(const Point& a, const Point& b, const Point& c) {
  return fits_double(a) && fits_double(b) && fits_double(c) ? Predicates<double>::orientation(a, b, c)
                                                            : Predicates<long double>::orientation(a, b, c);
}

/// Returns plane_orientation(a, b, c), faster if a rounded result is certain.
inline int quick_orientation(const Point& a, const Point& b, const Point& c) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  // An upper bound of the rounding error of left − right; the last term covers underflow.
  constexpr double epsilon = std::numeric_limits<double>::epsilon(), least = std::numeric_limits<double>::min();
  const double doubt = 8 * epsilon * (std::abs(left) + std::abs(right)) + least;
  if (left - right > doubt) return 1;
  return right - left > doubt ? -1 : plane_orientation(a, b, c);
}

/// Returns whether the closed triangle (a, b, c) contains `p`. Requires: (a, b, c) turns left.
inline bool holds(const Point& a, const Point& b, const Point& c, const Point& p) {
  return quick_orientation(a, b, p) >= 0 && quick_orientation(b, c, p) >= 0 && quick_orientation(c, a, p) >= 0;
}

/// Returns Predicates::in_circle(a, b, p, q), for any finite coordinates. Requires: (a, b, p) turns left.
inline int plane_in_circle(const Point& a, const Point& b, const Point& p, const Point& q) {
  return fits_double(a) && fits_double(b) && fits_double(p) && fits_double(q)
             ? Predicates<double>::in_circle(a, b, p, q)
             : Predicates<long double>::in_circle(a, b, p, q);
}

}  // namespace rbpa

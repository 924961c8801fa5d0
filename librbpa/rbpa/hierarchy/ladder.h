// What:   the ladder of radii: 2^i α₀, then the last one.
// Source: Restricted BPA, section 6.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "rbpa/pivot/radius.h"

namespace rbpa {

template <typename Real>
class Ladder {
 public:
  static constexpr int never = 0xffff;  ///< above all levels

  /// Requires: 0 < least < ∞. The ladder ends with the radius `last`. Where that is infinite, no level but the last has
  /// a radius above `largest`.
  Ladder(double least, Radius last, Real largest)
      : least_(least),
        last_(last),
        bound_(last.is_infinite() ? std::min(largest, Real(std::numeric_limits<double>::max())) : Real(last.value())) {}

  bool is_last(int level) const { return !(std::ldexp(Real(least_), level) < bound_); }
  Radius radius(int level) const { return is_last(level) ? last_ : Radius(std::ldexp(least_, level)); }

  /// A level such that the radii of all before it are less than `radius`, which may be rounded; seldom one too early.
  /// It may lie behind the last.
  int first_reaching(Real radius) const {
    constexpr Real deflated = 1 - Real(1e-5);
    const Real ratio = radius / Real(least_) * deflated;
    if (!(ratio > 1)) return 0;
    if (!(ratio < std::numeric_limits<Real>::infinity())) return never;
    int exponent;
    std::frexp(ratio, &exponent);
    return exponent;
  }

 private:
  double least_;
  Radius last_;
  Real bound_;
};

}  // namespace rbpa

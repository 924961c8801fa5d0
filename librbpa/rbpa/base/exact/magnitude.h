// What: computes the span of bits of coordinates, which decides the arithmetic that exact predicates need.
// Why:  if no exponent can leave its range, the error bounds of the filters count roundings only: underflow to zero and
//       infinity need no consideration.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>

#include "rbpa/base/point.h"

namespace rbpa {

/// Span of bits of coordinates: each coordinate but 0 is a multiple of 2^lowest, and its absolute value is below
/// 2^highest.
struct Magnitude {
  int lowest = 0;
  int highest = 0;
};

/// The narrowest span of the values included so far.
class NarrowestSpan {
 public:
  /// Includes a value. Requires: a finite value.
  void include(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52U) - 1);
    const auto exponent = static_cast<int>(bits >> 52U & 0x7ffU);
    if (exponent == 0 && fraction == 0) return;
    const std::uint64_t mantissa = exponent == 0 ? fraction : fraction | std::uint64_t{1} << 52U;
    const int unit = std::max(exponent, 1) - 1075;  // the value is mantissa · 2^unit
    lowest_ = std::min(lowest_, unit + std::countr_zero(mantissa));
    highest_ = std::max(highest_, unit + static_cast<int>(std::bit_width(mantissa)));
  }
  /// Returns the span; {0, 0} if every value is 0.
  Magnitude span() const { return lowest_ > highest_ ? Magnitude{} : Magnitude{lowest_, highest_}; }

 private:
  int lowest_ = std::numeric_limits<int>::max(), highest_ = std::numeric_limits<int>::min();
};

/// Returns the narrowest span of the coordinates; {0, 0} if every coordinate is 0. Requires: the points are finite.
Magnitude magnitude(std::span<const Point> points);

/// Returns a span that contains the narrowest, in a third of the time of magnitude(): assumes that every coordinate
/// uses all bits of a double, so that `lowest` may be lower than that of magnitude().
/// Requires: the points are finite.
Magnitude magnitude_bound(std::span<const Point> points);

/// The bounds on `lowest` and `highest` within which double is enough. The size of a difference of two coordinates is
/// then 0 or from 2^−150 to 2^151. Products in the predicates have a degree of at most six, and lie between 2^−900 and
/// 2^920, well inside the range of double. Products with alpha may leave this range; the resulting infinity or NaN
/// decides no comparison, so that the exact stage decides.
inline constexpr int least_in_double = -150, largest_in_double = 150;
constexpr bool fits_double(const Magnitude& m) { return m.lowest >= least_in_double && m.highest <= largest_in_double; }

/// Bounds on the circumradii of all triangles whose coordinates have a given Magnitude. The upper bound is |ab||bc||ca|
/// / 2|cross|, with sides below 2^(highest + 1.5) and a cross product of at least 2^(2 lowest). The lower bound is a
/// quarter of the shortest possible edge.
struct RadiusBounds {
  int above_all;  ///< every circumradius is at most 2^above_all
  int below_all;  ///< every circumradius is at least 2^below_all
};
constexpr RadiusBounds radius_bounds(const Magnitude& m) {
  return {3 * m.highest + 5 - 1 - 2 * m.lowest, m.lowest - 2};
}

}  // namespace rbpa

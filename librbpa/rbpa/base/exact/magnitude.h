// What: computes how many bits the input spans, which decides the arithmetic that its predicates need.
// Why:  in an arithmetic whose exponents cannot leave their range, the error bounds of the filters count roundings
//       only: underflow to zero and infinity need no consideration.
#pragma once

#include <span>

#include "rbpa/base/point.h"

namespace rbpa {

/// Span of bits of coordinates: each but 0 is a multiple of 2^lowest and below 2^highest in absolute value.
struct Magnitude {
  int lowest = 0;
  int highest = 0;
};

/// Returns the narrowest such span; 0 and 0 if every coordinate is 0. Requires: the points are finite.
Magnitude magnitude(std::span<const Point> points);

/// Returns a bound on the magnitude in a third of the time: `lowest` is computed as if every coordinate used all its
/// bits, so it may be lower than the exact one.
/// Requires: the points are finite.
Magnitude magnitude_bound(std::span<const Point> points);

/// The bounds on coordinates within which double is enough. Differences of such coordinates are 0 or between 2^−150 and
/// 2^151. Every product of them in the predicates, of degree six at most, then lies between 2^−900 and 2^920, well
/// inside the range of double. Products with alpha may leave it; the resulting infinity or NaN decides no comparison,
/// and the exact stage does.
inline constexpr int least_in_double = -150, largest_in_double = 150;
constexpr bool fits_double(const Magnitude& m) { return m.lowest >= least_in_double && m.highest <= largest_in_double; }

/// Bounds on the circumradii of all triangles whose coordinates have a given Magnitude. Upper bound: |ab||bc||ca| /
/// 2|cross|, with sides below 2^(highest + 1.5) and a cross product of at least 2^(2 lowest). Lower bound: half the
/// shortest possible edge.
struct RadiusBounds {
  int above_all;  ///< every circumradius is at most 2^above_all
  int below_all;  ///< every circumradius is at least 2^below_all
};
constexpr RadiusBounds radius_bounds(const Magnitude& m) {
  return {3 * m.highest + 5 - 1 - 2 * m.lowest, m.lowest - 2};
}

}  // namespace rbpa

// What: how many bits the input spans, which decides the arithmetic that its predicates need.
// Why:  in an arithmetic whose exponents cannot leave their range, the error bounds of the filters count roundings
//       only: no underflow to zero and no infinity has to be thought of.
#pragma once

#include <span>

#include "rbpa/core/point.h"

namespace rbpa {

/// Every nonzero coordinate is a multiple of 2^lowest and below 2^highest in absolute value.
struct Magnitude {
  int lowest = 0;
  int highest = 0;
};

Magnitude magnitude(std::span<const Point> points);

/// Differences of such coordinates are 0 or between 2^−150 and 2^151; every product in the predicates, of degree six in
/// them at most, then lies between 2^−900 and 2^920, well inside the range of double.
constexpr bool fits_double(const Magnitude& m) { return m.lowest >= -150 && m.highest <= 150; }

/// Where the coordinates fit double, no triangle with three distinct corners has a circumradius above the first value
/// (|ab||bc||ca| / 2|cross| ≤ (2^151.5)³ / (2 · 2^−300)) or below the second (half the shortest edge).
inline constexpr double radius_above_all = 0x1p+760;
inline constexpr double radius_below_all = 0x1p-152;

}  // namespace rbpa

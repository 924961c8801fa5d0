// What: distances to the sides of regions, rounded so that no point is missing.
#pragma once

#include <cmath>
#include <limits>

namespace rbpa::app {

/// At most a − b, and by little; at least a + b.
inline double below(double a, double b) {
  const double rounded = a - b;
  return rounded - std::abs(rounded) * 0x1p-52;
}
inline double above(double a, double b) {
  const double rounded = a + b;
  return rounded + std::abs(rounded) * 0x1p-52;
}

/// How far a point may be from a tile and matter for it: no less than 2 alpha; infinite beyond the range of double.
inline double reach_of(double alpha) { return std::nextafter(2 * alpha, std::numeric_limits<double>::infinity()); }

}  // namespace rbpa::app

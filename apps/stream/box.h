// What: a part of the plane with sides along the axes.
#pragma once

#include <cmath>
#include <limits>

#include "rbpa/core/point.h"

namespace rbpa::app {

/// Of its sides the lower belong to it, and the upper do not; any may be infinite.
struct Box {
  Point low = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  Point high = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

  bool contains(const Point& p) const { return low.x <= p.x && p.x < high.x && low.y <= p.y && p.y < high.y; }
  friend bool operator==(const Box&, const Box&) = default;
};

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

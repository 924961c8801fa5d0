// What: the quality of a triangle, from 0 to 1.
#pragma once

#include "rbpa/base/point.h"

namespace rbpa {

/// Returns the area over the sum of the squared sides (Lo, 1985), scaled and rounded: 1 for an equilateral triangle, 0
/// for a flat one, a negative number for a clockwise one.
inline double shape_quality(const Point& a, const Point& b, const Point& c) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - a.x, vy = c.y - a.y, wx = c.x - b.x, wy = c.y - b.y;
  const double squares = ux * ux + uy * uy + vx * vx + vy * vy + wx * wx + wy * wy;
  constexpr double of_equal_sides = 3.4641016151377544;  // 2 √3
  return squares > 0 ? of_equal_sides * (ux * vy - uy * vx) / squares : 0;
}

}  // namespace rbpa

// What: the window of doubles on a set of points: scaled by a power of two, most of the points fit double. The few
//       points that are far larger or far finer than the others lie beyond the window.
// Why:  filters decide points that fit double without regard to underflow and overflow (magnitude.h), and nearly all
//       input fits double, at least when scaled.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/exact/magnitude.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/predicate/radius.h"

namespace rbpa {

struct Window {
  int exponent = 0;                   ///< the points in the window fit double when multiplied by 2^exponent
  std::vector<std::uint32_t> beyond;  ///< the positions of the points beyond the window, ascending
  RadiusBounds bounds{};              ///< bounds of the circumradii of points in the window, scaled

  /// Returns alpha in the scale of the window: 2^exponent alpha, or an equivalent value if all circumradii are larger
  /// or all smaller.
  Radius scaled(const Radius& alpha) const;
};

/// Returns the window that has the most points. If that window has fewer than ⌊n / 2⌋ of the n points, the origin not
/// counted, all points are beyond the window. The exponent is 0 if all points fit unscaled. The result is a function of
/// the set of points.
/// Requires: finite points.
/// Cost:     linear.
Window window_of(std::span<const Point> points);

}  // namespace rbpa

// What: the bounding box of points in the plane.
#pragma once

#include <algorithm>
#include <limits>

#include "rbpa/base/point.h"

namespace rbpa::app {

/// The box from `least` to `greatest`, which has no point at first.
struct Box {
  Point least = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point greatest = {-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  /// Extends the box to a point.
  void add(const Point& p) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    greatest = {std::max(greatest.x, p.x), std::max(greatest.y, p.y)};
  }
};

}  // namespace rbpa::app

// What: computes bounding boxes of points in space, and tests whether boxes meet.
#pragma once

#include <algorithm>
#include <limits>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// The bounding box of points. A box of no points meets no other box.
struct Box {
  Point3 low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  void include(const Point3& p) { include(Box{p, p}); }
  void include(const Box& box) {
    low = {std::min(low.x, box.low.x), std::min(low.y, box.low.y), std::min(low.z, box.low.z)};
    high = {std::max(high.x, box.high.x), std::max(high.y, box.high.y), std::max(high.z, box.high.z)};
  }
  friend bool operator==(const Box&, const Box&) = default;
  /// Returns whether the boxes overlap or touch.
  bool meets(const Box& box) const {
    return low.x <= box.high.x && box.low.x <= high.x && low.y <= box.high.y && box.low.y <= high.y &&
           low.z <= box.high.z && box.low.z <= high.z;
  }
  /// Returns the squared distance of a point from the box, rounded.
  double squared_distance(const Point3& p) const {
    const double x = std::max({low.x - p.x, p.x - high.x, 0.0}), y = std::max({low.y - p.y, p.y - high.y, 0.0}),
                 z = std::max({low.z - p.z, p.z - high.z, 0.0});
    return x * x + y * y + z * z;
  }
};

/// Returns the bounding box of a range of points.
template <typename Points>
Box box_of(const Points& points) {
  Box box;
  for (const Point3& p : points) box.include(p);
  return box;
}

}  // namespace rbpa::space

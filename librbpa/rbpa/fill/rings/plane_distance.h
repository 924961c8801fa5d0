// What: the rounded distance of a point from a segment, and a quick test that finds most large distances.
#pragma once

#include <algorithm>
#include <cmath>

#include "rbpa/base/point.h"

namespace rbpa {

inline double distance(const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::sqrt(dx * dx + dy * dy);
}

/// Returns the distance of `p` from the segment ab.
inline double distance(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double along = square > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / square : 0;
  const double share = std::clamp(along, 0.0, 1.0);
  return distance(p, {a.x + share * dx, a.y + share * dy});
}

/// Returns whether `p` is beyond the bounding box of the segment ab by more than `reach`, in x or in y. The distance
/// from the segment is then above `reach`.
inline bool is_surely_clear(const Point& p, const Point& a, const Point& b, double reach) {
  return p.x - std::max(a.x, b.x) > reach || std::min(a.x, b.x) - p.x > reach || p.y - std::max(a.y, b.y) > reach ||
         std::min(a.y, b.y) - p.y > reach;
}

}  // namespace rbpa

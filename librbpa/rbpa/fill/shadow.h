// What: a convex part of the plane that a segment hides from a point, or that lies behind one.
// Why:  where long edges lie close, most of what is near an edge of a front is hidden from it by a few others, and need not
//       be looked at (docs/fill.md, section 2).
#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "rbpa/base/point.h"
#include "rbpa/fill/plane_predicates.h"

namespace rbpa {

class Shadow {
 public:
  /// What is right of the line from a to b.
  static Shadow behind(const Point& a, const Point& b) { return Shadow({b, b, b}, {a, a, a}); }
  /// The places from which a way straight to `eye` crosses the segment from p to q, or passes an end of it.
  /// Requires: the eye is left of it.
  static Shadow cast(const Point& eye, const Point& p, const Point& q) { return Shadow({eye, q, q}, {p, eye, p}); }

  /// Whether the whole segment lies in it. Exact.
  bool hides(const Point& p, const Point& q) const { return holds(p) && holds(q); }

 private:
  Shadow(const std::array<Point, 3>& from, const std::array<Point, 3>& to) : from_(from), to_(to) {}
  /// The last line is that of the segment, which is in nobody's shadow.
  bool holds(const Point& p) const { return side(0, p) >= 0 && side(1, p) >= 0 && side(2, p) > 0; }
  /// The orientation, which is plain in nearly all cases.
  int side(std::size_t i, const Point& p) const {
    const Point &u = from_[i], &v = to_[i];
    const double left = (v.x - u.x) * (p.y - u.y), right = (v.y - u.y) * (p.x - u.x);
    // More than differences, products and their difference can be off; the last for what underflows.
    constexpr double epsilon = std::numeric_limits<double>::epsilon(), least = std::numeric_limits<double>::min();
    const double doubt = 8 * epsilon * (std::abs(left) + std::abs(right)) + least;
    if (left - right > doubt) return 1;
    return right - left > doubt ? -1 : plane_orientation(u, v, p);
  }

  std::array<Point, 3> from_, to_;  // of lines that it lies left of
};

}  // namespace rbpa

// What: a point of the plane, in the user's coordinates.
#pragma once

#include <cmath>
#include <compare>

namespace rbpa {

/// A point of the plane; any finite value. The order is lexicographic, x before y, and −0 equals +0.
struct Point {
  double x = 0;
  double y = 0;
  friend constexpr bool operator==(const Point&, const Point&) = default;
  friend constexpr auto operator<=>(const Point&, const Point&) = default;
};

/// Returns whether both coordinates are finite.
inline bool is_finite(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

}  // namespace rbpa

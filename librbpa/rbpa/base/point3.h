// What: a point of space, in the user's coordinates.
#pragma once

#include <cmath>
#include <compare>

namespace rbpa {

/// A point of space, or a vector. Functions that take points require finite coordinates. The order is lexicographic, x
/// before y before z, and −0 equals +0.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;
  friend constexpr bool operator==(const Point3&, const Point3&) = default;
  friend constexpr auto operator<=>(const Point3&, const Point3&) = default;
};

/// Returns whether all coordinates are finite.
inline bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace rbpa

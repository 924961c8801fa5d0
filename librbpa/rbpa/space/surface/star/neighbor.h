// What: keeps a point relative to another point v, with its power and distance.
#pragma once

#include <cmath>
#include <cstddef>

#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/resting_ball.h"

namespace rbpa::space {

inline Vector3<double> scaled(const Vector3<double>& u, double s) { return {u.x * s, u.y * s, u.z * s}; }

/// A point other than v. A ball that touches v, with its center at c relative to v, contains the point if and only if c
/// · at > power.
struct Neighbor {
  Vector3<double> at;  // the point relative to v
  double power;        // half the square of its distance from v
  double length;       // its distance from v
  std::size_t site;

  static Neighbor seen_from(const Point3& v, const Point3& p, std::size_t site) {
    const Vector3<double> at = from<double>(v, p);
    const double square = dot(at, at);
    return {at, square / 2, std::sqrt(square), site};
  }
  /// Returns Σ|atᵢ|, by which errors of centers are multiplied.
  double size() const { return std::abs(at.x) + std::abs(at.y) + std::abs(at.z); }
};

}  // namespace rbpa::space

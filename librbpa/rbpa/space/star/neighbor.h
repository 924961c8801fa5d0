// What: a point as another one sees it.
#pragma once

#include <cmath>
#include <cstddef>

#include "rbpa/core/point3.h"
#include "rbpa/space/predicate/ball.h"

namespace rbpa::space {

/// A point other than v: where it is from v, half the square of its distance, and that; and a number, by which it is asked for.
struct Neighbor {
  Vector3<double> at;
  double power, length;
  std::size_t number;

  static Neighbor seen_from(const Point3& v, const Point3& p, std::size_t number) {
    const Vector3<double> at = from<double>(v, p);
    const double square = dot(at, at);
    return {at, square / 2, std::sqrt(square), number};
  }
  /// The sum of the sizes of its coordinates.
  double size() const { return std::abs(at.x) + std::abs(at.y) + std::abs(at.z); }
};

}  // namespace rbpa::space

// What: coordinates modulo the sides of a box.
// Law:  the sides and all coordinates are multiples of a step that is so small, and so large, that every image at most one box away is a double.
//       Rounding moves a coordinate by at most 2⁻⁵² of the power of two above the side.
#pragma once

#include <array>
#include <cstdint>

#include "rbpa/base/point3.h"

namespace rbpa::space {

using Offset = std::array<std::int8_t, 3>;

class Torus {
 public:
  /// Throws InvalidInput unless all sides are from 2⁻⁹⁰⁰ to 2⁹⁰⁰.
  explicit Torus(const Point3& box);

  /// Rounded.
  const Point3& box() const { return box_; }
  /// Below half of the least side: a ball of this radius does not touch its images.
  double most_radius() const { return most_radius_; }

  /// Modulo the box: 0 ≤ x < side. Requires: finite.
  Point3 wrapped(const Point3& p) const;
  /// Requires: a point that is wrapped, at most one box away. Exact.
  Point3 image(const Point3& p, const Offset& offset) const {
    return {p.x + offset[0] * box_.x, p.y + offset[1] * box_.y, p.z + offset[2] * box_.z};
  }

 private:
  Point3 given_, step_, box_;
  double most_radius_;
};

}  // namespace rbpa::space

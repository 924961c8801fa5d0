// What: reduces coordinates modulo the sides of a periodic box.
// Law:  along each axis, the side and all coordinates are rounded to multiples of a step. Every image at most one box
//       away is then a double. Rounding moves a coordinate by at most 2⁻⁵² of the power of two above the side.
#pragma once

#include <array>
#include <cstdint>

#include "rbpa/base/point3.h"

namespace rbpa::space {

using Offset = std::array<std::int8_t, 3>;  ///< numbers of boxes along the axes

class Torus {
 public:
  /// Sets the sides. Throws InvalidInput unless all sides are from 2⁻⁹⁰⁰ to 2⁹⁰⁰.
  explicit Torus(const Point3& box);

  /// Returns the sides of the box, rounded to the step.
  const Point3& box() const { return box_; }
  /// Returns the greatest double below half of the least side: a ball of this radius does not touch its own images.
  double most_radius() const { return most_radius_; }

  /// Returns p modulo the box, rounded to the step: each coordinate is from 0 to below the side. Requires: finite p.
  Point3 wrapped(const Point3& p) const;
  /// Returns the exact image of p at `offset`. Requires: p is wrapped; `offset` is at most one box along each axis.
  Point3 image(const Point3& p, const Offset& offset) const {
    return {p.x + offset[0] * box_.x, p.y + offset[1] * box_.y, p.z + offset[2] * box_.z};
  }

 private:
  Point3 given_, step_, box_;
  double most_radius_;
};

}  // namespace rbpa::space

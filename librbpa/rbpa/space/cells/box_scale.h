// What: scales points relative to a box, so that no difference or product overflows; a scaled point is a place.
// Law:  a coordinate of a place is rounded once, as the scale is a power of two.
#pragma once

#include <algorithm>
#include <cmath>

#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

class BoxScale {
 public:
  /// Makes the scale of the box from `low` to `high`. Requires: finite corners, low <= high.
  BoxScale(const Point3& low, const Point3& high) : low_(low) {
    // Coordinates are halved, so that differences of extreme ones are finite.
    std::frexp(std::max({high.x / 2 - low.x / 2, high.y / 2 - low.y / 2, high.z / 2 - low.z / 2}), &exponent_);
    ++exponent_;
  }

  /// Returns the exponent of the scale: a unit of places is 2^exponent() units of the points.
  int exponent() const { return exponent_; }
  /// Returns the place of a point: its scaled offset from the lower corner. Coordinates are from 0 to 1 within the box.
  Vector3<double> place(const Point3& p) const { return {along(p.x, low_.x), along(p.y, low_.y), along(p.z, low_.z)}; }
  /// Returns the point at a place, rounded.
  Point3 point(const Vector3<double>& place) const {
    return {back(place.x, low_.x), back(place.y, low_.y), back(place.z, low_.z)};
  }

 private:
  double back(double at, double low) const { return std::ldexp(at + std::ldexp(low, -exponent_), exponent_); }
  double along(double x, double low) const { return std::ldexp(x, -exponent_) - std::ldexp(low, -exponent_); }

  Point3 low_;
  int exponent_ = 0;
};

}  // namespace rbpa::space

// What: scales points in space and a radius, if possible, so that products in filters neither underflow nor overflow.
// Law:  the factor is a power of two, so that scaling is exact (cells/scale.h).
// Cost: linear; a copy of the points where the factor is not 1.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/cells/scale.h"

namespace rbpa::space {

/// Scaled points and a scaled radius. Refers to the given points if the factor is 1 or there is no factor. Requires:
/// what scale_to_double() requires.
class ScaledPoints {
 public:
  ScaledPoints(std::span<const Point3> points, double radius) : points_(points), radius_(radius) {
    const std::optional<int> exponent = scale_to_double(points, radius);
    fits_double_ = exponent.has_value();
    if (!exponent || *exponent == 0) return;
    const auto scale = [&](double value) { return std::ldexp(value, *exponent); };
    own_.reserve(points.size());
    for (const Point3& p : points) own_.push_back({scale(p.x), scale(p.y), scale(p.z)});
    points_ = own_;
    radius_ = scale(radius);
  }

  ScaledPoints(const ScaledPoints&) = delete;
  ScaledPoints& operator=(const ScaledPoints&) = delete;

  std::span<const Point3> points() const { return points_; }
  double radius() const { return radius_; }
  /// Returns whether points and radius fit double. If not, points() and radius() are not scaled.
  bool fits_double() const { return fits_double_; }

 private:
  std::vector<Point3> own_;
  std::span<const Point3> points_;
  double radius_;
  bool fits_double_;
};

}  // namespace rbpa::space

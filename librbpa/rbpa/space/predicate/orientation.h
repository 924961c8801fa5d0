// What: computes on which side of a triangle's plane, or of a line that is seen along an axis, a point is.
// Law:  exact for every finite input.
// How:  a floating-point filter; then, for planes, integers of fixed width if differences fit; then expansions if
//       products stay in the range of double; then integers of any length (docs/explanation/surfaces.md, section 15).
// Cost: some nanoseconds; a tenth of a microsecond for points in a plane, microseconds at extreme exponents.
#pragma once

#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/normal_sign.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

/// Returns the sign of (b − a) × (c − a) · (d − a), or of (b − a) × (c − a) along an axis, without a filter.
int orientation_exactly(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
int orientation_along_exactly(const Point3& a, const Point3& b, const Point3& c, int axis);

/// Constants of the filters: the error is below `orientation_filter`, eight unit roundoffs, times the sum of the
/// absolute values of all terms. For a bound up to `least_filtered`, terms may underflow.
constexpr double orientation_filter = 0x1p-50, least_filtered = 0x1p-900;

/// Returns the sign of (b − a) × (c − a) · (d − a): 1 when a, b, c are counter-clockwise seen from d.
inline int orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const RoundedNormal<double> normal(a, b, c);
  const Vector3<double> w = from<double>(a, d);
  const double product = normal.product({w.x, w.y, w.z});
  const double bound = orientation_filter * normal.magnitude({w.x, w.y, w.z});
  if (bound > least_filtered) {  // also false for NaN
    if (product > bound) return 1;
    if (product < -bound) return -1;
  }
  return orientation_exactly(a, b, c, d);
}

/// Returns the sign of (b − a) × (c − a) along an axis, 0 to 2: 1 if a, b, c are counter-clockwise seen down the axis.
inline int orientation_along(const Point3& a, const Point3& b, const Point3& c, int axis) {
  const Point3 along = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
  const RoundedNormal<double> normal(a, b, c);
  const double product = normal.product(along), bound = orientation_filter * normal.magnitude(along);
  if (bound > least_filtered) {
    if (product > bound) return 1;
    if (product < -bound) return -1;
  }
  return orientation_along_exactly(a, b, c, axis);
}

/// Returns whether all three points are on one line.
inline bool are_collinear(const Point3& a, const Point3& b, const Point3& c) {
  return orientation_along(a, b, c, 0) == 0 && orientation_along(a, b, c, 1) == 0 && orientation_along(a, b, c, 2) == 0;
}

}  // namespace rbpa::space

// What: computes the radius of the least sphere through two or three points, and tests whether a point is inside.
// Law:  exact for every finite input. A point on the sphere is not inside.
// How:  a filter in long double (docs/explanation/exact_decisions.md, section 7), then integers of any length.
// Cost: some ten nanoseconds; microseconds where the filter fails.
#pragma once

#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

/// Returns whether the least sphere through a and b has a radius of at most `radius`. Requires: a != b, a finite
/// radius.
bool is_least_sphere_within(const Point3& a, const Point3& b, double radius);

/// Returns the least double that is not below the radius of the least sphere through a and b; infinity if no double is
/// large enough. Requires: a != b.
double least_radius_rounded_up(const Point3& a, const Point3& b);

/// Returns whether q is inside the least sphere through a and b.
bool in_least_sphere(const Point3& a, const Point3& b, const Point3& q);

/// A formula for the power of a point a + d to the least sphere through a, b, c, times n²: n² d² − axis · d.
template <typename Number>
struct PowerByLeastSphere {
  PowerByLeastSphere(const Point3& a, const Point3& b, const Point3& c);

  Vector3<Number> axis;
  Number square;  ///< n²
  // For the error bound, with edges u and v from a: u² v², |u| + |v| and min(u², v²).
  Number product_of_squares, lengths, least_square;
};

/// The least sphere through three points that are on no line. Keeps references to the points.
class LeastSphere {
 public:
  LeastSphere(const Point3& a, const Point3& b, const Point3& c);

  /// Returns whether the radius of the sphere is at most `radius`. Requires: a finite radius.
  bool is_within(double radius) const;
  /// Returns the least double that is not below the radius of the sphere; infinity if no double is large enough.
  double radius_rounded_up() const;
  bool has_inside(const Point3& q) const;

 private:
  const Point3 &a_, &b_, &c_;
  PowerByLeastSphere<double> power_;
};

}  // namespace rbpa::space

// What: the least sphere through two or three points: its radius, and whether a point is inside.
// Law:  exact for every finite input. A point on the sphere is not inside.
// How:  a filter in long double (docs/explanation/exact_decisions.md, section 7), then integers of any length.
// Cost: some ten nanoseconds; microseconds where the filter fails.
#pragma once

#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

/// Returns whether the least sphere through a and b has at most this radius. Requires: a != b, a finite radius.
bool is_least_sphere_within(const Point3& a, const Point3& b, double radius);

/// Returns the least double that is not below the radius; infinity above all doubles. Requires: distinct points.
double least_radius_rounded_up(const Point3& a, const Point3& b);

/// Returns whether q is inside the least sphere through a and b.
bool in_least_sphere(const Point3& a, const Point3& b, const Point3& q);

/// The power of a point with respect to the least sphere through three points, times the square of their normal n: n²
/// d² − axis · d for a point at d from the first of the three.
template <typename Number>
struct PowerByLeastSphere {
  PowerByLeastSphere(const Point3& a, const Point3& b, const Point3& c);

  Vector3<Number> axis;
  Number square;  ///< n²
  // For the error bound: u² v², |u| + |v| and min(u², v²), with u and v the edges from a.
  Number product_of_squares, lengths, least_square;
};

/// The least sphere through three points that are on no line. Keeps references to them.
class LeastSphere {
 public:
  LeastSphere(const Point3& a, const Point3& b, const Point3& c);

  /// Returns whether the radius of the sphere is at most `radius`. Requires: a finite radius.
  bool is_within(double radius) const;
  /// Returns the least double that is not below the radius; infinity above all doubles.
  double radius_rounded_up() const;
  bool has_inside(const Point3& q) const;

 private:
  const Point3 &a_, &b_, &c_;
  PowerByLeastSphere<double> power_;
};

}  // namespace rbpa::space

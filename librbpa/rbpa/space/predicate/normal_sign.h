// What: tests whether the normal of a triangle agrees with another vector.
// Law:  exact for every finite input (docs/explanation/surfaces.md, section 15).
// Cost: some nanoseconds; microseconds when the filter fails.
#pragma once

#include <cmath>
#include <limits>

#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

/// The normal (b − a) × (c − a), rounded.
template <typename Real>
class RoundedNormal {
 public:
  RoundedNormal(const Point3& a, const Point3& b, const Point3& c) {
    const Vector3<Real> u = from<Real>(a, b), v = from<Real>(a, c);
    normal_ = cross(u, v);
    magnitude_ = {std::abs(u.y * v.z) + std::abs(u.z * v.y), std::abs(u.z * v.x) + std::abs(u.x * v.z),
                  std::abs(u.x * v.y) + std::abs(u.y * v.x)};
  }
  Real product(const Point3& v) const { return normal_.x * Real(v.x) + normal_.y * Real(v.y) + normal_.z * Real(v.z); }
  /// Returns the sum of the absolute values of the terms of product(v), whose error is a small fraction of this sum.
  Real magnitude(const Point3& v) const {
    return magnitude_.x * std::abs(Real(v.x)) + magnitude_.y * std::abs(Real(v.y)) + magnitude_.z * std::abs(Real(v.z));
  }

 private:
  Vector3<Real> normal_, magnitude_;
};

/// The normal (b − a) × (c − a), for exact signs.
class TriangleNormal {
 public:
  TriangleNormal(const Point3& a, const Point3& b, const Point3& c) : a_(a), b_(b), c_(c), rounded_(a, b, c) {}

  /// Returns the sign of (b − a) × (c − a) · v.
  int sign_along(const Point3& v) const {
    const Real product = rounded_.product(v), bound = 8 * unit_roundoff * rounded_.magnitude(v);
    if (product > bound) return 1;
    if (product < -bound) return -1;
    if (bound == 0) return 0;  // all products are 0, and not by underflow
    return exact::normal_sign(a_, b_, c_, v);
  }

 private:
  using Real = long double;  // normals may have exponents far from those of the points
  static constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

  Point3 a_, b_, c_;
  RoundedNormal<Real> rounded_;
};

}  // namespace rbpa::space

// What: computes the sign of the scalar product of a triangle's normal with a vector or another triangle's normal.
// Law:  exact for every finite input (docs/explanation/surfaces.md, section 15).
// Cost: some nanoseconds; microseconds when the filters fail.
#pragma once

#include <cmath>
#include <limits>

#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

/// The normal (b − a) × (c − a), with rounding errors.
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
  /// Returns the sum of the absolute values of the terms of product(v). The error of product(v) is a small fraction of
  /// this sum.
  Real magnitude(const Point3& v) const {
    return magnitude_.x * std::abs(Real(v.x)) + magnitude_.y * std::abs(Real(v.y)) + magnitude_.z * std::abs(Real(v.z));
  }

  /// Returns the scalar product with another normal; magnitude() returns the sum of absolute values. A coordinate of a
  /// normal has at most four roundings, and a term of the product nine, so that the error of product() is below 16 unit
  /// roundoffs of magnitude().
  Real product(const RoundedNormal& other) const { return dot(normal_, other.normal_); }
  Real magnitude(const RoundedNormal& other) const { return dot(magnitude_, other.magnitude_); }
  /// Returns the sum of the absolute values of all products of differences.
  Real size() const { return magnitude_.x + magnitude_.y + magnitude_.z; }

 private:
  Vector3<Real> normal_, magnitude_;
};

/// The normal (b − a) × (c − a), for exact signs of scalar products.
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

/// Returns the sign of (b − a) × (c − a) · (e − d) × (f − d).
inline int compare_normals(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e,
                           const Point3& f) {
  {
    const RoundedNormal<double> one(a, b, c), other(d, e, f);
    const double product = one.product(other),
                 bound = 8 * std::numeric_limits<double>::epsilon() * one.magnitude(other) +
                         0x1p-1000 * (1 + one.size() + other.size());
    if (product > bound) return 1;
    if (product < -bound) return -1;
  }
  using Real = long double;  // its exponents hold products of four differences of doubles
  const RoundedNormal<Real> one(a, b, c), other(d, e, f);
  const Real product = one.product(other), bound = 8 * std::numeric_limits<Real>::epsilon() * one.magnitude(other);
  if (product > bound) return 1;
  if (product < -bound) return -1;
  if (bound == 0) return 0;  // all products are 0, and not by underflow
  return exact::compare_normals(a, b, c, d, e, f);
}

/// Returns whether a triangle (a, b, c) that becomes (d, e, f) turns by less than a right angle and still has an area.
/// The result is true for any (d, e, f) if (a, b, c) has no area.
inline bool keeps_direction(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e,
                            const Point3& f) {
  const int sign = compare_normals(a, b, c, d, e, f);
  return sign > 0 || (sign == 0 && compare_normals(a, b, c, a, b, c) == 0);
}

}  // namespace rbpa::space

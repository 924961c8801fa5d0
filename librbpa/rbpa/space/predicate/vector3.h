// What: differences of points in space, in double, long double or integers, and their products.
#pragma once

#include "rbpa/base/point3.h"

namespace rbpa::space {

template <typename Real>
struct Vector3 {
  Real x, y, z;
};

template <typename Real>
Vector3<Real> from(const Point3& a, const Point3& b) {
  return {Real(b.x) - Real(a.x), Real(b.y) - Real(a.y), Real(b.z) - Real(a.z)};
}
template <typename Real>
Real dot(const Vector3<Real>& u, const Vector3<Real>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <typename Real>
Vector3<Real> cross(const Vector3<Real>& u, const Vector3<Real>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

}  // namespace rbpa::space

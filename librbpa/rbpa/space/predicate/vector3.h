// What: computes differences of points in space, sums and products of these in any type of number, and rounded
//       distances and volumes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <type_traits>

#include "rbpa/base/point3.h"

namespace rbpa::space {

template <typename Real>
struct Vector3 {
  Real x, y, z;
};

/// Returns b − a.
template <typename Real>
Vector3<Real> from(const Point3& a, const Point3& b) {
  return {Real(b.x) - Real(a.x), Real(b.y) - Real(a.y), Real(b.z) - Real(a.z)};
}
template <typename Real>
Vector3<Real> plus(const Vector3<Real>& u, const Vector3<Real>& v) {
  return {u.x + v.x, u.y + v.y, u.z + v.z};
}
template <typename Real>
Vector3<Real> minus(const Vector3<Real>& u, const Vector3<Real>& v) {
  return {u.x - v.x, u.y - v.y, u.z - v.z};
}
/// Returns v times s.
template <typename Real>
Vector3<Real> times(const std::type_identity_t<Real>& s, const Vector3<Real>& v) {
  return {s * v.x, s * v.y, s * v.z};
}
template <typename Real>
Real dot(const Vector3<Real>& u, const Vector3<Real>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}
template <typename Real>
Vector3<Real> cross(const Vector3<Real>& u, const Vector3<Real>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// Returns the number rounded to float. Not inlined, as g++ 12 omits the rounding when it vectorizes two calls.
[[gnu::noinline]] inline double to_single(double x) { return static_cast<double>(static_cast<float>(x)); }

inline double distance(const Point3& a, const Point3& b) { return std::hypot(b.x - a.x, b.y - a.y, b.z - a.z); }

/// Returns the volume of a tetrahedron, with rounding errors. The result does not depend on the order of corners.
template <typename Real>
Real volume(std::span<const Point3> points, const std::array<std::uint32_t, 4>& corners) {
  std::array<Point3, 4> p = {points[corners[0]], points[corners[1]], points[corners[2]], points[corners[3]]};
  std::sort(p.begin(), p.end());
  const Vector3<Real> u = from<Real>(p[0], p[1]), v = from<Real>(p[0], p[2]), w = from<Real>(p[0], p[3]);
  return std::abs(dot(cross(u, v), w)) / 6;
}

}  // namespace rbpa::space

#include "rbpa/space/predicate/least_sphere.h"

#include <cmath>
#include <limits>

#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {
namespace {

using Real = long double;
using Vector = Vector3<Real>;
constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

/// The sign of a value that is off by at most `error`, or that which exact() computes. What overflowed is compared in vain.
template <typename Exact>
int sign(Real value, Real error, Exact exact) {
  return value > error ? 1 : value < -error ? -1 : exact();
}

}  // namespace

bool is_least_sphere_within(const Point3& a, const Point3& b, double radius) {
  const Vector u = from<Real>(a, b);
  const Real square = dot(u, u), diameter = 4 * Real(radius) * Real(radius);
  return sign(diameter - square, 8 * unit_roundoff * (diameter + square),
              [&] { return -exact::compare_circumradius(a, b, radius); }) >= 0;
}

bool is_least_sphere_within(const Point3& a, const Point3& b, const Point3& c, double radius) {
  const Vector u = from<Real>(a, b), v = from<Real>(a, c), w = from<Real>(b, c), n = cross(u, v);
  const Real uu = dot(u, u), vv = dot(v, v), diameter = 4 * Real(radius) * Real(radius);
  const Real sides = uu * vv * dot(w, w);
  return sign(diameter * dot(n, n) - sides, unit_roundoff * (80 * diameter * uu * vv + 24 * sides),
              [&] { return -exact::compare_circumradius(a, b, c, radius); }) >= 0;
}

bool in_least_sphere(const Point3& a, const Point3& b, const Point3& q) {
  const Vector u = from<Real>(q, a), v = from<Real>(q, b);
  return sign(dot(u, v), 8 * unit_roundoff * std::sqrt(dot(u, u) * dot(v, v)),
              [&] { return -exact::side_of_least_sphere(a, b, q); }) < 0;
}

bool in_least_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& q) {
  const Vector u = from<Real>(a, b), v = from<Real>(a, c), d = from<Real>(a, q), n = cross(u, v);
  const Real uu = dot(u, u), vv = dot(v, v), dd = dot(d, d), length = std::sqrt(dd);
  const Real power = dot(n, n) * dd - uu * dot(cross(v, n), d) - vv * dot(cross(n, u), d);
  return sign(power, 96 * unit_roundoff * uu * vv * length * (length + std::sqrt(uu) + std::sqrt(vv)),
              [&] { return -exact::side_of_least_sphere(a, b, c, q); }) < 0;
}

}  // namespace rbpa::space

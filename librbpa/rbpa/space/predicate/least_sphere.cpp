#include "rbpa/space/predicate/least_sphere.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rbpa/base/exact/least_reaching.h"
#include "rbpa/space/predicate/exact.h"

namespace rbpa::space {
namespace {

using Real = long double;
using Vector = Vector3<Real>;
constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

/// Returns the sign of `value` if an error of at most `error` cannot change the sign, else exact(). After an overflow,
/// exact() decides.
template <typename Exact>
int sign(Real value, Real error, Exact exact) {
  return value > error ? 1 : value < -error ? -1 : exact();
}

/// The power of a point, and a bound of its error. If `value` is below −error, the point is certainly inside.
template <typename Number>
struct Power {
  Number value, error;
};

template <typename Number, typename Exact>
int sign(const Power<Number>& power, Exact exact) {
  return power.value > power.error ? 1 : power.value < -power.error ? -1 : exact();
}

/// Returns `value` with `error`, or with an infinite error if a part of `value` may underflow. A part may underflow if
/// `least_square`, the least square of an edge, is not far above the least normal number, or the square of `error` is
/// not above this number. An infinite error leaves the decision to the next type of number.
template <typename Number>
Power<Number> within_range(Number value, Number error, Number least_square) {
  constexpr Number least = std::numeric_limits<Number>::min();
  const bool fits = least_square > 0x1p100 * least && error * error > least;
  return {value, fits ? error : std::numeric_limits<Number>::infinity()};
}

template <typename Number>
Power<Number> beside_least_sphere(const Point3& a, const Point3& b, const Point3& q) {
  const Vector3<Number> u = from<Number>(q, a), v = from<Number>(q, b);
  constexpr Number roundoff = std::numeric_limits<Number>::epsilon() / 2;
  const Number uu = dot(u, u), vv = dot(v, v);
  return within_range(dot(u, v), 8 * roundoff * std::sqrt(uu * vv), std::min(uu, vv));
}

template <typename Number>
Power<Number> beside(const PowerByLeastSphere<Number>& by, const Point3& a, const Point3& q) {
  const Vector3<Number> d = from<Number>(a, q);
  constexpr Number roundoff = std::numeric_limits<Number>::epsilon() / 2;
  const Number dd = dot(d, d), length = std::sqrt(dd);
  return within_range(by.square * dd - dot(by.axis, d),
                      96 * roundoff * by.product_of_squares * length * (length + by.lengths),
                      std::min(by.least_square, dd));
}

using rbpa::rounded_up;

/// Returns the exact radius, rounded up. `radius` is an estimate with an error of at most `error`. If both ends of its
/// interval round up to one double, this double is the result; otherwise reaches() decides between doubles.
template <typename Reaches>
double rounded_up(Real radius, Real error, const Reaches& reaches) {
  const double low = rounded_up(radius - error), high = rounded_up(radius + error);
  return low == high && std::isnormal(low) ? low : least_reaching(static_cast<double>(radius), reaches);
}

}  // namespace

bool is_least_sphere_within(const Point3& a, const Point3& b, double radius) {
  const Vector u = from<Real>(a, b);
  const Real square = dot(u, u), diameter = 4 * Real(radius) * Real(radius);
  return sign(diameter - square, 8 * unit_roundoff * (diameter + square),
              [&] { return -exact::compare_circumradius(a, b, radius); }) >= 0;
}

template <typename Number>
PowerByLeastSphere<Number>::PowerByLeastSphere(const Point3& a, const Point3& b, const Point3& c) {
  const Vector3<Number> u = from<Number>(a, b), v = from<Number>(a, c), n = cross(u, v), vn = cross(v, n),
                        nu = cross(n, u);
  const Number uu = dot(u, u), vv = dot(v, v);
  axis = {uu * vn.x + vv * nu.x, uu * vn.y + vv * nu.y, uu * vn.z + vv * nu.z};
  square = dot(n, n);
  product_of_squares = uu * vv;
  lengths = std::sqrt(uu) + std::sqrt(vv);
  least_square = std::min(uu, vv);
}

LeastSphere::LeastSphere(const Point3& a, const Point3& b, const Point3& c) : a_(a), b_(b), c_(c), power_(a, b, c) {}

bool LeastSphere::is_within(double radius) const {
  const Vector u = from<Real>(a_, b_), v = from<Real>(a_, c_), w = from<Real>(b_, c_), n = cross(u, v);
  const Real uu = dot(u, u), vv = dot(v, v), diameter = 4 * Real(radius) * Real(radius);
  const Real sides = uu * vv * dot(w, w);
  return sign(diameter * dot(n, n) - sides, unit_roundoff * (80 * diameter * uu * vv + 24 * sides),
              [&] { return -exact::compare_circumradius(a_, b_, c_, radius); }) >= 0;
}

double least_radius_rounded_up(const Point3& a, const Point3& b) {
  const Vector u = from<Real>(a, b);
  const Real radius = std::sqrt(dot(u, u)) / 2;
  return rounded_up(radius, 8 * unit_roundoff * radius, [&](double r) { return is_least_sphere_within(a, b, r); });
}

double LeastSphere::radius_rounded_up() const {
  const Vector u = from<Real>(a_, b_), v = from<Real>(a_, c_), w = from<Real>(b_, c_), n = cross(u, v);
  const Real uu = dot(u, u), vv = dot(v, v), nn = dot(n, n), spread = uu * vv / nn;
  const Real radius = std::sqrt(uu * vv * (dot(w, w) / nn)) / 2;
  // The error is that of is_within(), halved by the root; n² is off by at most 80 unit roundoffs of u² v².
  const Real error =
      spread < 0x1p40L ? unit_roundoff * radius * (32 + 96 * spread) : std::numeric_limits<Real>::infinity();
  return rounded_up(radius, error, [&](double r) { return is_within(r); });
}

bool in_least_sphere(const Point3& a, const Point3& b, const Point3& q) {
  return sign(beside_least_sphere<double>(a, b, q), [&] {
           return sign(beside_least_sphere<Real>(a, b, q), [&] { return -exact::side_of_least_sphere(a, b, q); });
         }) < 0;
}

bool LeastSphere::has_inside(const Point3& q) const {
  return sign(beside(power_, a_, q), [&] {
           return sign(beside(PowerByLeastSphere<Real>(a_, b_, c_), a_, q),
                       [&] { return -exact::side_of_least_sphere(a_, b_, c_, q); });
         }) < 0;
}

}  // namespace rbpa::space

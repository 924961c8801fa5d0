// What:   tests whether a ball of a given radius rests on three points, and which points this ball contains.
// Law:    exact for every finite input. The ball counts as larger by an infinitesimal, and points count as moved by
//         even smaller infinitesimals (the symbolic perturbation), so that no fourth point touches the ball.
//         docs/explanation/surfaces.md, sections 10 and 14.
// How:    a floating-point filter whose bounds are computed with the ball (docs/explanation/surfaces.md, section 15);
//         then long double, then integers of any length.
// Cost:   about 120 operations for a ball, and twenty for a test of a point, bounds of errors included; microseconds
//         where a filter fails.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

/// Returns whether q is in the ball of radius `radius` that rests on a, b and c, its center on the side from which they
/// are counter-clockwise. Integers decide; if q touches the ball, the perturbation decides.
/// Requires: the circumradius of a, b and c is at most `radius`.
bool in_ball_exactly(const Point3& a, const Point3& b, const Point3& c, double radius, const Point3& q);

/// The ball of a given radius that touches a, b and c, its center on the side from which they are counter-clockwise.
/// Real is double for points and a radius scaled by scale_to_double() (space/cells/scale.h), else long double.
template <typename Real>
class RestingBall {
  static_assert(std::numeric_limits<Real>::is_iec559);
  static_assert(std::is_same_v<Real, double> || std::numeric_limits<Real>::max_exponent >= 16384,
                "long double has the exponents of double here: extreme coordinates could not be filtered");

 public:
  static constexpr Real unit_roundoff =
      std::numeric_limits<Real>::epsilon() / 2;  ///< the relative error of one rounding

  /// Makes an object without a ball; rests() is false.
  RestingBall() = default;
  /// Makes the ball if it exists. Requires: distinct points, a finite radius above 0.
  RestingBall(const Point3& a, const Point3& b, const Point3& c, double radius) : a_(a), b_(b), c_(c), radius_(radius) {
    rests_ = fill_in();
  }

  /// Returns whether the ball exists: whether the circumradius of the three points is at most the radius.
  bool rests() const { return rests_; }

  /// Returns whether q is inside the ball. Requires: rests(); q is not a, b or c.
  bool contains(const Point3& q) const {
    const Estimate power = power_of(q);
    if (power.value > power.bound) return false;
    if (power.value < -power.bound) return true;
    return decide(q);
  }

  /// Returns the side of the plane of a, b and c on which q is: 1 for the side from which a, b, c are
  /// counter-clockwise, −1 for the other side, 0 in the plane. Requires: an object with three points.
  int side_of_plane(const Point3& q) const {
    const Vector3<Real> d = from<Real>(a_, q);
    const Real height = dot(normal_, d);
    const Real bound = normal_error_ * (std::abs(d.x) + std::abs(d.y) + std::abs(d.z));
    if (height > bound) return 1;
    if (height < -bound) return -1;
    return exact::orientation(a_, b_, c_, q);
  }

 private:
  template <typename>
  friend class RestingBall;
  struct Estimate {
    Real value, bound;
  };

  /// Computes all members except the points. Returns rests().
  bool fill_in() {
    constexpr Real e = unit_roundoff;
    const Vector3<Real> u = from<Real>(a_, b_), v = from<Real>(a_, c_), w = from<Real>(b_, c_), n = cross(u, v);
    const Real uu = dot(u, u), vv = dot(v, v), nn = dot(n, n), u_size = std::sqrt(uu), v_size = std::sqrt(vv);
    const Real n_size = std::sqrt(nn), n_error = 8 * e * u_size * v_size;
    const Real nn_error = n_error * (2 * n_size + n_error) + 4 * e * nn;
    normal_ = n;
    normal_error_ = n_error + 8 * e * n_size;

    const Real diameter = 4 * Real(radius_) * Real(radius_), sides = uu * vv * dot(w, w);
    const Real clearance = diameter * nn - sides;  // D
    const Real clearance_error = diameter * nn_error + e * (4 * diameter * nn + 24 * sides);
    int sign = clearance > clearance_error ? 1 : clearance < -clearance_error ? -1 : 0;
    Real root = 0, root_error = 0;
    if (sign == 0) sign = -exact::compare_circumradius(a_, b_, c_, radius_);
    if (sign < 0) return false;
    if (sign > 0) {
      root = std::sqrt(std::max(clearance, Real(0)));
      root_error = std::sqrt(clearance_error);
      if (root > root_error) root_error = clearance_error / root;
      root_error += 2 * e * root;
    }

    const Vector3<Real> to_u = cross(v, n), to_v = cross(n, u);
    const Real edges = u_size * v_size * (u_size + v_size);
    const Real k_error = edges * (n_error + 20 * e * n_size);
    const Real center_error = k_error + root * (n_error + 4 * e * n_size) + (n_size + n_error) * root_error;
    square_ = nn;
    center_ = {uu * to_u.x + vv * to_v.x + root * n.x, uu * to_u.y + vv * to_v.y + root * n.y,
               uu * to_u.z + vv * to_v.z + root * n.z};
    square_bound_ = nn_error + 8 * e * nn;
    center_bound_ = center_error + 6 * e * (std::abs(center_.x) + std::abs(center_.y) + std::abs(center_.z));
    return true;
  }

  /// Returns n² times the power of q with respect to the ball (negative inside), with a bound of its error.
  Estimate power_of(const Point3& q) const {
    const Vector3<Real> d = from<Real>(a_, q);
    const Real dd = dot(d, d);
    return {square_ * dd - dot(center_, d),
            square_bound_ * dd + center_bound_ * (std::abs(d.x) + std::abs(d.y) + std::abs(d.z))};
  }

  bool decide(const Point3& q) const {
    if constexpr (std::is_same_v<Real, double> && std::numeric_limits<long double>::digits == 64) {
      RestingBall<long double> finer;
      finer.a_ = a_, finer.b_ = b_, finer.c_ = c_, finer.radius_ = radius_;
      finer.fill_in();
      const auto power = finer.power_of(q);
      if (power.value > power.bound) return false;
      if (power.value < -power.bound) return true;
    }
    return in_ball_exactly(a_, b_, c_, radius_, q);
  }

  Point3 a_, b_, c_;
  double radius_ = 0;
  bool rests_ = false;
  Vector3<Real> normal_{};  // n = (b − a) × (c − a)
  Real normal_error_ = 0;
  Vector3<Real> center_{};  // 2 n² (center − a)
  Real square_ = 0;         // n²
  Real square_bound_ = 0, center_bound_ = 0;
};

}  // namespace rbpa::space

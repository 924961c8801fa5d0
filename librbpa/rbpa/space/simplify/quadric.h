// What:   sums of weighted squared distances to planes and points, as functions of a point (quadrics).
// Law:    the value at a point is the sum of these weighted squared distances, up to rounding; a + b equals b + a, bit
//         for bit.
// Source: Garland and Heckbert, Surface simplification using quadric error metrics (1997); Trettner and Kobbelt, Fast
//         and robust QEF minimization using probabilistic quadrics (2020).
#pragma once

#include <cmath>
#include <optional>

#include "rbpa/base/point3.h"

namespace rbpa {

/// The function x ↦ xᵀAx + 2bᵀx + c, with A symmetric.
class Quadric {
 public:
  Quadric() = default;
  /// Returns `weight` times the squared distance to the plane through p with the unit normal n, plus `weight` times
  /// `noise` times the squared distance to p. This sum is the mean of the first term if each coordinate of the normal
  /// has the variance `noise`.
  static Quadric plane(const Point3& n, const Point3& p, double weight, double noise = 0) {
    const double at = n.x * p.x + n.y * p.y + n.z * p.z;
    Quadric q;
    q.xx_ = weight * (n.x * n.x + noise);
    q.yy_ = weight * (n.y * n.y + noise);
    q.zz_ = weight * (n.z * n.z + noise);
    q.xy_ = weight * n.x * n.y;
    q.xz_ = weight * n.x * n.z;
    q.yz_ = weight * n.y * n.z;
    q.x_ = -weight * (at * n.x + noise * p.x);
    q.y_ = -weight * (at * n.y + noise * p.y);
    q.z_ = -weight * (at * n.z + noise * p.z);
    q.one_ = weight * (at * at + noise * (p.x * p.x + p.y * p.y + p.z * p.z));
    return q;
  }

  Quadric& operator+=(const Quadric& q) {
    xx_ += q.xx_, yy_ += q.yy_, zz_ += q.zz_, xy_ += q.xy_, xz_ += q.xz_, yz_ += q.yz_;
    x_ += q.x_, y_ += q.y_, z_ += q.z_, one_ += q.one_;
    return *this;
  }
  Quadric& operator*=(double factor) {
    for (double* term : {&xx_, &yy_, &zz_, &xy_, &xz_, &yz_, &x_, &y_, &z_, &one_}) *term *= factor;
    return *this;
  }
  friend Quadric operator+(Quadric a, const Quadric& b) { return a += b; }

  /// Returns the value at a point. Rounding may make it slightly negative.
  double operator()(const Point3& p) const {
    const double x = xx_ * p.x + 2 * (xy_ * p.y + xz_ * p.z + x_), y = yy_ * p.y + 2 * (yz_ * p.z + y_);
    return p.x * x + p.y * y + p.z * (zz_ * p.z + 2 * z_) + one_;
  }

  /// Returns the point with the least value; nothing if the planes do not determine it: if a pivot of the solution is
  /// at most `least` times the trace of A, or a coordinate is not finite.
  std::optional<Point3> minimum(double least = 1e-12) const {
    const double limit = least * (xx_ + yy_ + zz_);
    if (!(xx_ > limit)) return std::nullopt;
    const double l = xy_ / xx_, m = xz_ / xx_, pivot = yy_ - l * xy_;
    if (!(pivot > limit)) return std::nullopt;
    const double n = (yz_ - l * xz_) / pivot, last = zz_ - m * xz_ - n * n * pivot;
    if (!(last > limit)) return std::nullopt;
    const double u = -x_, v = -y_ - l * u, w = -z_ - m * u - n * v;
    const double z = w / last, y = v / pivot - n * z;
    const Point3 p = {u / xx_ - l * y - m * z, y, z};
    return is_finite(p) ? std::optional(p) : std::nullopt;
  }

 private:
  double xx_ = 0, yy_ = 0, zz_ = 0, xy_ = 0, xz_ = 0, yz_ = 0;  // A
  double x_ = 0, y_ = 0, z_ = 0;                                // b
  double one_ = 0;                                              // c
};

}  // namespace rbpa

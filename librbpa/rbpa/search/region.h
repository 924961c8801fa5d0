// What: a part of the plane to be searched: the common part of a box, a disc and up to two half-planes.
// Law:  conservative. row() may give an interval that is too wide, never one that misses a point of the true region,
//       although every number here is rounded: each bound is moved outward by more than its error.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "rbpa/predicate/predicates.h"

namespace rbpa {

template <typename Real>
class Region {
 public:
  using Vector = typename Predicates<Real>::Vector;

  struct Interval {
    Real low, high;
    bool empty() const { return !(low <= high); }
  };

  /// The whole plane.
  Region() = default;

  static Region box(Interval x, Interval y) {
    Region region;
    region.x_ = x;
    region.y_ = y;
    return region;
  }

  static Region disc(Vector centre, Real radius) {
    Region region;
    region.set_disc(centre, radius);
    region.x_ = {centre.x - region.radius_, centre.x + region.radius_};
    region.y_ = {centre.y - region.radius_, centre.y + region.radius_};
    return region;
  }

  /// The points left of a→b inside the circle through a and b whose centre lies `k` half-chords left of the chord's
  /// midpoint; all points left of a→b when k is infinite.
  static Region segment(const Point& a, const Point& b, Real k) {
    const Vector d = Predicates<Real>::from(a, b);
    return segment(a, b, std::sqrt(Predicates<Real>::dot(d, d)), k);
  }

  /// The same, the length of the chord being known.
  static Region segment(const Point& a, const Point& b, Real length, Real k) {
    Region region;
    const Vector d = Predicates<Real>::from(a, b), left{-d.y, d.x};
    if (k < std::numeric_limits<Real>::infinity()) {
      const Real half = k / 2;
      const Vector centre{Real(a.x) + d.x / 2 + half * left.x, Real(a.y) + d.y / 2 + half * left.y};
      region.set_disc(centre, length / 2 * std::sqrt(1 + k * k));
      // The disc's extreme points bound the segment where they lie left of the chord; else the chord's ends do.
      const Real r = region.radius_, reach = half * length * length;
      const Interval ends_x{Real(std::min(a.x, b.x)), Real(std::max(a.x, b.x))};
      const Interval ends_y{Real(std::min(a.y, b.y)), Real(std::max(a.y, b.y))};
      // Where rounding decides the question below, the disc reaches beyond the end by its own slack and a little more.
      const Real slack = 2 * region.slack_;
      region.x_ = {r * left.x <= reach ? centre.x - r : ends_x.low - slack,
                   r * left.x >= -reach ? centre.x + r : ends_x.high + slack};
      region.y_ = {r * left.y <= reach ? centre.y - r : ends_y.low - slack,
                   r * left.y >= -reach ? centre.y + r : ends_y.high + slack};
    }
    region.keep_left(a, d);
    return region;
  }

  /// Cuts away what lies right of the line through a in direction d. At most twice.
  void keep_left(const Point& a, const Vector& d) {
    if (d.y == 0) {
      if (d.x > 0) y_.low = std::max(y_.low, Real(a.y));
      if (d.x < 0) y_.high = std::min(y_.high, Real(a.y));
      return;
    }
    const Real slope = d.x / d.y;  // of x over y along the line
    if (!std::isfinite(slope)) return;
    const Real error = 16 * Predicates<Real>::unit * (std::abs(Real(a.x)) + std::abs(slope) * std::abs(Real(a.y)));
    cut_[cuts_++] = {Real(a.x), Real(a.y), slope, error, d.y < 0};
  }

  Interval x_range() const { return x_; }
  Interval y_range() const { return y_; }

  /// Where the region meets the row low ≤ y ≤ high.
  Interval row(Real low, Real high) const {
    Interval x = x_;
    if (has_disc_) {
      const Real away = std::max({Real(0), low - centre_.y, centre_.y - high});
      const Real rest = radius_ * radius_ - away * away;
      if (rest < 0) return {1, 0};
      const Real half = std::sqrt(rest);
      x.low = std::max(x.low, centre_.x - half);
      x.high = std::min(x.high, centre_.x + half);
    }
    for (int i = 0; i < cuts_; ++i) {
      const Cut& cut = cut_[i];
      const Real at_low = cut.slope * (low - cut.y), at_high = cut.slope * (high - cut.y);
      const Real error = cut.error + 8 * Predicates<Real>::unit * (std::abs(at_low) + std::abs(at_high));
      if (cut.keep_greater)
        x.low = std::max(x.low, cut.x + std::min(at_low, at_high) - error);
      else
        x.high = std::min(x.high, cut.x + std::max(at_low, at_high) + error);
    }
    return x;
  }

 private:
  struct Cut {
    Real x, y, slope, error;
    bool keep_greater;
  };

  void set_disc(Vector centre, Real radius) {
    has_disc_ = true;
    centre_ = centre;
    slack_ = 32 * Predicates<Real>::unit * (std::abs(centre.x) + std::abs(centre.y) + radius);
    radius_ = radius + slack_;
  }

  static constexpr Real infinity = std::numeric_limits<Real>::infinity();
  Interval x_{-infinity, infinity}, y_{-infinity, infinity};
  bool has_disc_ = false;
  int cuts_ = 0;
  Vector centre_{0, 0};
  Real radius_ = 0;  // larger than the true one by slack_
  Real slack_ = 0;
  Cut cut_[2];
};

}  // namespace rbpa

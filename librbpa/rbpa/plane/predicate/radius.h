// What: the ball's radius, with infinity as a state of its own.
#pragma once

#include <cmath>
#include <optional>

#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {

/// The alpha of a computation: a positive number, or infinite. A number above every circumradius may become infinite.
class Radius {
 public:
  Radius() = default;
  explicit Radius(double alpha) : alpha_(alpha) {}
  /// Returns the radius `alpha`, which may be infinity.
  static Radius of(double alpha) { return std::isinf(alpha) ? Radius() : Radius(alpha); }

  bool is_infinite() const { return !alpha_; }
  /// Returns the number. Requires: a finite radius.
  double value() const { return *alpha_; }

  /// Returns whether the circumradius of (a, b, c), corners not on a line, is ≤ alpha.
  template <typename Real>
  bool admits(const Point& a, const Point& b, const Point& c) const {
    return !alpha_ || Predicates<Real>::compare_circumradius(a, b, c, *alpha_) <= 0;
  }
  /// Returns whether a ball can touch both points: |ab| ≤ 2 alpha.
  template <typename Real>
  bool spans(const Point& a, const Point& b) const {
    return !alpha_ || Predicates<Real>::compare_to_diameter(a, b, *alpha_) <= 0;
  }

 private:
  std::optional<double> alpha_;
};

}  // namespace rbpa

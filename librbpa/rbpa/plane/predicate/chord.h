// What: points that compete for a circle through the ends of a chord. Of the points left of the chord, the one with the
//       least circle has the least k = dot / cross: docs/explanation/plane.md, section 1.
// Law:  the results are those of the predicates.
// Why:  the products of a point and a chord are computed once for each point, not for each pair of points.
#pragma once

#include <bit>
#include <cmath>
#include <type_traits>

#include "rbpa/base/exact/two.h"
#include "rbpa/plane/predicate/predicates.h"

namespace rbpa {

template <typename Real>
class Chord {
 public:
  Chord(const Point& from, const Point& to)
      : from_(from), to_(to), a_(of(from)), b_(of(to)), mirrored_((b_ - a_) * Two<Real>{1, -1}) {}

  /// The products (p − a) · (p − b) and (b − a) × (p − a) of a point p, and the magnitudes of both.
  struct Candidate {
    const Point* at;
    Two<Real> dot_and_cross, magnitude;
  };
  /// Returns the products of p and the chord. The result keeps a pointer to p.
  Candidate candidate(const Point& p) const {
    const Two<Real> at = of(p), ap = at - a_, bp = at - b_;
    const Two<Real> dot = ap * bp, cross = mirrored_ * swapped(ap);
    const Two<Real> first = firsts(dot, cross), second = seconds(dot, cross);
    return {&p, first + second, magnitudes(first) + magnitudes(second)};
  }

  bool is_left(const Candidate& p) const {
    const Real cross = p.dot_and_cross[1];
    if (std::abs(cross) <= 5 * P::unit_roundoff * p.magnitude[1]) [[unlikely]]
      return P::orientation(from_, to_, *p.at) > 0;
    return cross > 0;
  }

  /// Returns whether q is inside the circle through the chord and p; the symbolic perturbation breaks ties. Requires: p
  /// is left of the chord, and q is another point.
  bool is_inside(const Candidate& q, const Candidate& p) const {
    const Two<Real> products = p.dot_and_cross * swapped(q.dot_and_cross), sizes = p.magnitude * swapped(q.magnitude);
    const Real difference = products[0] - products[1];
    if (std::abs(difference) <= 11 * P::unit_roundoff * (sizes[0] + sizes[1])) [[unlikely]]
      return P::in_perturbed_circle(from_, to_, *p.at, *q.at) > 0;
    return difference > 0;
  }

 private:
  using P = Predicates<Real>;

  static Two<Real> of(const Point& p) {
    if constexpr (std::is_same_v<Real, double>)
      return std::bit_cast<Two<Real>>(p);
    else
      return {p.x, p.y};
  }

  Point from_, to_;
  Two<Real> a_, b_, mirrored_;  // the ends; (b − a) with the sign of y reversed
};

}  // namespace rbpa

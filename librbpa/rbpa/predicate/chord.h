// What: points that compete for a circle through the ends of a chord: of those left of it, the one with the least circle
//       has the least k = dot / cross: docs/pivot.md, section 1.
// Law:  the answers are those of the predicates.
// Why:  what a point and a chord have in common is computed once for each point, not for each pair of them.
#pragma once

#include <cmath>

#include "rbpa/predicate/predicates.h"

namespace rbpa {

template <typename Real>
class Chord {
 public:
  Chord(const Point& from, const Point& to) : a_(from), b_(to), ab_(P::from(from, to)) {}

  struct Candidate {
    Point at;
    Real dot, cross, dot_magnitude, cross_magnitude;
  };
  Candidate candidate(const Point& p) const {
    const auto ap = P::from(a_, p), bp = P::from(b_, p);
    return {p, P::dot(ap, bp), P::cross(ab_, ap), P::dot_magnitude(ap, bp), P::cross_magnitude(ab_, ap)};
  }

  bool is_left(const Candidate& p) const {
    if (std::abs(p.cross) <= 5 * P::unit_roundoff * p.cross_magnitude) [[unlikely]]
      return P::orientation(a_, b_, p.at) > 0;
    return p.cross > 0;
  }

  /// q is inside the circle through the chord and p, ties perturbed. Requires p to be left, and q another point.
  bool is_inside(const Candidate& q, const Candidate& p) const {
    const Real difference = p.dot * q.cross - q.dot * p.cross;
    const Real bound =
        11 * P::unit_roundoff * (p.dot_magnitude * q.cross_magnitude + q.dot_magnitude * p.cross_magnitude);
    if (std::abs(difference) <= bound) [[unlikely]]
      return P::in_perturbed_circle(a_, b_, p.at, q.at) > 0;
    return difference > 0;
  }

 private:
  using P = Predicates<Real>;

  Point a_, b_;
  typename P::Vector ab_;
};

}  // namespace rbpa

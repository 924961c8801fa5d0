// What: the least double alpha at which a triangle, or an edge, is in the complex.
// Law:  exact: least_alpha(a, b, c) ≤ alpha if and only if the circumradius of (a, b, c) is ≤ alpha, for every double
//       alpha > 0. A complex "at alpha" is therefore the cells whose least alpha is ≤ alpha, compared as plain doubles.
// How:  computes an interval around the radius in long double. Nearly always a single double is the rounded-up radius;
//       otherwise the exact predicates choose among the doubles that the interval leaves.
//       docs/explanation/filtration_and_persistence.md, section 2 derives the interval.
// Cost: about 0.1 µs; 1 µs where the interval does not decide (one triangle of fifteen), some µs at a tie.
#pragma once

#include "rbpa/base/point.h"

namespace rbpa {

/// Returns the circumradius of (a, b, c), rounded up; infinity if it is above all doubles.
/// Requires: a, b, c are not on a line.
double least_alpha(const Point& a, const Point& b, const Point& c);

/// Returns half the distance of a and b, rounded up. Requires: a and b are not equal.
double least_alpha(const Point& a, const Point& b);

}  // namespace rbpa

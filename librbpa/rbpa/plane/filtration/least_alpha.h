// What: computes the least alpha at which a triangle is in the complex: its circumradius, rounded up to a double. For
//       an edge: half its length, rounded up likewise, which is its least alpha if no point is inside its diametral
//       circle.
// Law:  exact: least_alpha(a, b, c) ≤ alpha if and only if the circumradius of (a, b, c) is ≤ alpha, for every double
//       alpha > 0. A complex "at alpha" is therefore the cells whose least alpha is ≤ alpha, compared as plain doubles.
// How:  computes an interval around the radius in long double. For fourteen triangles of fifteen, both ends of the
//       interval round up to the same double; for the others, the exact predicates choose among the doubles that the
//       interval leaves. docs/explanation/filtration_and_persistence.md, section 2 derives the interval.
// Cost: about 0.1 µs if the interval decides, 1 µs if it does not (one triangle of fifteen), some µs at a tie.
#pragma once

#include "rbpa/base/point.h"

namespace rbpa {

/// Returns the circumradius of (a, b, c), rounded up; infinity if it is above all doubles.
/// Requires: a, b, c are not on a line.
double least_alpha(const Point& a, const Point& b, const Point& c);

/// Returns half the distance of a and b, rounded up. Requires: a and b are not equal.
double least_alpha(const Point& a, const Point& b);

}  // namespace rbpa

// What:   the least double alpha at which a triangle, or an edge, is in the complex.
// Law:    exact: least_alpha(a, b, c) ≤ alpha exactly when the circumradius of (a, b, c) is ≤ alpha, for every double
//         alpha > 0. So a complex "at alpha" is the cells whose least alpha is ≤ alpha, compared as plain doubles.
// How:    an interval that holds the radius, in long double; nearly always one double only rounds it up. Else the exact
//         predicates choose among the doubles that the interval leaves. docs/filtration.md derives the interval.
// Cost:   about 0.1 µs; 1 µs where the interval does not decide (one triangle of fifteen), some µs at a tie.
#pragma once

#include "rbpa/base/point.h"

namespace rbpa {

/// The circumradius of (a, b, c) rounded up; infinity when it is above all doubles.
/// Requires: a, b, c are not on a line.
double least_alpha(const Point& a, const Point& b, const Point& c);

/// Half the distance of a and b rounded up. Requires: a and b are not equal.
double least_alpha(const Point& a, const Point& b);

}  // namespace rbpa

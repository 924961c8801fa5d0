// What: the signs behind every decision, in integers of any length: the last stage of each predicate.
// Cost: microseconds, growing with the span of the exponents.
#pragma once

#include "rbpa/base/point.h"

namespace rbpa::exact_integer {

/// Returns 1 if a, b, c turn left, −1 if they turn right, 0 if they are on a line.
int orientation(const Point& a, const Point& b, const Point& c);

/// Returns 1 if q is inside the circle through a, b, p, −1 if outside, 0 if on it. Requires: (a, b, p) turns left.
int in_circle(const Point& a, const Point& b, const Point& p, const Point& q);

/// Returns the sign of (circumradius of (a, b, c)) − alpha. Requires: corners not on a line; finite alpha > 0.
int compare_circumradius(const Point& a, const Point& b, const Point& c, double alpha);

/// Returns the sign of |ab| − 2 alpha. Requires: finite alpha > 0.
int compare_to_diameter(const Point& a, const Point& b, double alpha);

/// Returns the sign of |vp| − |vq|.
int compare_distances(const Point& v, const Point& p, const Point& q);

/// Returns the sign of (p − v) · (q − v).
int dot(const Point& v, const Point& p, const Point& q);

}  // namespace rbpa::exact_integer

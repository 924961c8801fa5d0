// What: the right results of the predicates, by rational numbers and from the textbook definitions, not by the formulas
//       of the library.
#pragma once

#include "rbpa/base/point.h"

namespace rbpa_test::exact {

using rbpa::Point;

/// Returns the sign of the area of (a, b, c).
int orientation(const Point& a, const Point& b, const Point& c);

/// Returns the sign of the 4 × 4 in-circle determinant: 1 when q is inside the circle of (a, b, p), which turn left.
int in_circle(const Point& a, const Point& b, const Point& p, const Point& q);

/// Returns the sign of the in-circle determinant with every lift x² + y² raised by its own infinitesimal, the
/// lexicographically larger point's infinitely larger: the sign of the first nonzero coefficient of the expansion.
int in_perturbed_circle(const Point& a, const Point& b, const Point& p, const Point& q);

/// Returns the sign of (distance of the circumcenter from a) − alpha. Requires: a, b, c not on a line.
int compare_circumradius(const Point& a, const Point& b, const Point& c, double alpha);

/// Returns the sign of |ab| − 2 alpha.
int compare_to_diameter(const Point& a, const Point& b, double alpha);

/// Returns the sign of |vp| − |vq|.
int compare_distances(const Point& v, const Point& p, const Point& q);

/// Returns the sign of (p − v) · (q − v).
int dot_sign(const Point& v, const Point& p, const Point& q);

/// Returns whether |p − center| ≤ radius.
bool in_disc(const Point& center, double radius, const Point& p);

}  // namespace rbpa_test::exact

// What: points where lines and bisectors meet, and the signs of a Voronoi diagram that is cut by lines.
// Law:  signs are exact. A constructed coordinate is the real number rounded once, to nearest, ties to even; infinite
//       beyond the range of double.
// How:  double-double numbers with an error bound decide nearly always, and integers of any length otherwise.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa {

/// A directed line from one point through another.
struct Line {
  Point from, to;
};

/// Returns the circumcenter. Requires: (a, b, c) turns left.
Point circumcenter(const Point& a, const Point& b, const Point& c);

/// Returns the point where two lines meet. Requires: they are not parallel.
Point crossing(const Line& one, const Line& other);

/// Returns the point where the line meets the bisector of p and q. Requires: they are not parallel.
Point crossing_of_bisector(const Point& p, const Point& q, const Line& line);

/// Returns 1 if the circumcenter is left of the line, −1 if right, 0 if on it. Requires: (a, b, c) turns left.
int side_of_circumcenter(const Line& line, const Point& a, const Point& b, const Point& c);

/// Returns the sign of (line.to − line.from) · (q − p).
int dot_sign(const Line& line, const Point& p, const Point& q);

/// Returns the numbers of the lines in the order in which the bisector of p and q, passed with p on the left, meets
/// them. Of lines that meet it at one point, the order is that after all lines are moved by (ε, ε²), for small ε > 0.
/// Requires: no line is parallel to the bisector.
std::vector<std::size_t> order_along_bisector(const Point& p, const Point& q, std::span<const Line> lines);

}  // namespace rbpa

// What: computes the least power of a simplex of balls and its sign, and tests whether a ball conflicts with a simplex.
//       The power of a point x to a ball is |x − center|² − radius². The orthocenter of a simplex is the point of least
//       power among the points with equal powers to all its balls. A ball conflicts if the orthocenter has a lower
//       power to this ball.
// Law:  exact for all finite balls: the sign of a power of 0 is 0, and a ball with an equal power does not conflict.
// How:  a filter (docs/explanation/exact_decisions.md, sections 7 and 8), then integers of any length.
// Cost: some ten nanoseconds; microseconds where the filter fails.
#pragma once

#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

struct Ball {
  Point3 center;
  double radius = 0;
};

/// Returns the sign of the power at the orthocenter of two to four balls. If the sign is not positive, the balls have a
/// point in common. Requires: the centers are affinely independent.
int least_power_sign(const Ball& a, const Ball& b);
int least_power_sign(const Ball& a, const Ball& b, const Ball& c);
int least_power_sign(const Ball& a, const Ball& b, const Ball& c, const Ball& d);

/// Returns the least double that is not below the power p at the orthocenter of one to four balls; with `is_root`, not
/// below its signed root: √p, or −√−p for a negative p. Returns infinity if no double is large enough.
/// Requires: the centers are affinely independent.
double least_power_rounded_up(std::span<const Ball> balls, bool is_root);

/// Returns whether q conflicts with one to three balls. Requires: the centers of these are affinely independent.
bool is_conflict(const Ball& a, const Ball& q);
bool is_conflict(const Ball& a, const Ball& b, const Ball& q);
bool is_conflict(const Ball& a, const Ball& b, const Ball& c, const Ball& q);

}  // namespace rbpa::space

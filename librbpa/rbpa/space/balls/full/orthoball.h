// What: computes the orthocenter of three or four balls (orthosphere.h decides its signs), and the ball that touches
//       them.
// Law:  the order of the balls does not change the result. Computed in double-double: the relative error is about 2⁻⁵³,
//       unless the simplex of the centers is extremely flat.
#pragma once

#include <span>

#include "rbpa/space/predicate/orthosphere.h"

namespace rbpa::space {

struct Orthoball {
  Point3 center;     ///< the point with the same power to all balls, in the plane of three centers
  double power = 0;  ///< power of the center
  /// The ball that touches all balls from outside, with its center in the same plane or space; not a number if there is
  /// none.
  Ball touching;
};

/// Returns the orthocenter and the touching ball. Requires: centers that are affinely independent; lengths between
/// 2⁻¹⁵⁰ and 2¹⁵⁰, or 0.
Orthoball orthoball(std::span<const Ball> balls);

}  // namespace rbpa::space

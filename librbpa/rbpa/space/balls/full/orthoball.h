// What: the orthocenter of three or four balls as numbers (orthosphere.h has its signs), and the ball touching them.
// Law:  the same for any order of the balls. Computed in double-double: off by some 2⁻⁵³ of itself, unless the simplex
//       is much flatter than thin.
#pragma once

#include <span>

#include "rbpa/space/predicate/orthosphere.h"

namespace rbpa::space {

struct Orthoball {
  Point3 center;     ///< the point of least power in the plane or space of the centers that has the same power to all
  double power = 0;  ///< of the center
  /// The ball that touches all from outside, with its center in the same plane or space; not a number if there is none.
  Ball touching;
};

/// Requires: centers that are affinely independent; lengths between 2⁻¹⁵⁰ and 2¹⁵⁰, or 0.
Orthoball orthoball(std::span<const Ball> balls);

}  // namespace rbpa::space

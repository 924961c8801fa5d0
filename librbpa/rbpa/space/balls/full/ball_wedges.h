// What: angles and areas around the common circle of two balls, within one tetrahedron of the dual complex, or beside a
//       triangle of it that has no tetrahedron on that side.
// How:  docs/explanation/space.md, section 24. Where terms cancel, they are computed again in double-double.
// Law:  errors are some 2^−43 of a full turn, or of the square of a radius.
#pragma once

#include "rbpa/space/predicate/orthosphere.h"

namespace rbpa::space {

/// The part of the contact of two balls that is in a wedge.
struct WedgePart {
  double angle = 0;   ///< of the wedge; 0 if not requested
  double area = 0;    ///< of the contact's part, less its sector of the disc within the circle where that is exposed
  double growth = 0;  ///< derivative of the area when all radii grow alike, less the same
};

/// The circle in which the spheres of balls i and j meet. Keeps references.
class BallCircle {
 public:
  BallCircle(const Ball& i, const Ball& j);

  double distance;            ///< of the centers
  double height_i, height_j;  ///< signed distances of the circle's plane from the centers, toward the other center
  double square;              ///< of the radius

  /// Returns the part in the tetrahedron of balls i, j, k, l.
  WedgePart in_tetrahedron(const Ball& k, const Ball& l, bool with_angle) const;
  /// Returns the part between the triangle of balls i, j, k and the point beside it in which their spheres meet.
  WedgePart beside_triangle(const Ball& k) const;

 private:
  const Ball &i_, &j_;
};

/// Returns the angle at the sphere of ball i, in the point where it meets those of j and k, between the directions
/// toward j and k: of the spherical triangle of these directions and that point.
double corner_angle(const Ball& i, const Ball& j, const Ball& k);

}  // namespace rbpa::space

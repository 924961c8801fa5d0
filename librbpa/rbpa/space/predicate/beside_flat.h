// What: finds points beside a flat set of points or balls that make the triangulation in space a cone over that of the
//       set.
// Law:  the sphere through three points of a plane and any other point cuts the plane in the circle of the three. With
//       one point anywhere beside the plane, the bases of the tetrahedra are the Delaunay triangles of the set, and
//       ties are the same: no point is projected or rounded. With two points beside a line, the tetrahedra contain its
//       edges. The set is on one face of the hull, and the lower hull of this face is that of the lifts of the set
//       alone: so the same holds for the regular triangulation of balls.
// Cost: linear.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Returns points that, together with `points`, are in no plane, each alone on its side: one if `points` are in a
/// plane, two if they are on a line, three if they are all equal. The returned points are in the least cube with its
/// center at the origin that contains `points`, unless that is a single point.
/// Requires: finite points in one plane, at least one.
std::vector<Point3> beside_flat(std::span<const Point3> points);

}  // namespace rbpa::space

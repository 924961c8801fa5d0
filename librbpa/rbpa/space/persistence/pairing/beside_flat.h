// What: finds points beside a set in a plane or on a line; with them, the Delaunay triangulation in space is a cone
//       over that of the set.
// Law:  the sphere through three points of a plane and any other point cuts the plane in the circle of the three. So
//       with one point beside the plane, at any place, the tetrahedra stand on the Delaunay triangles of the set, with
//       the same ties: nothing is projected or rounded. With two beside a line, they stand on its edges.
// Cost: linear.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Returns one point outside of the plane if all points are in one plane; two if they are on one line; none if they are
/// in no plane, or all equal. The returned points are in the least cube around the origin that contains `points`.
/// Requires: finite points.
std::vector<Point3> beside_flat(std::span<const Point3> points);

}  // namespace rbpa::space

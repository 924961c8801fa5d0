// What: finds points beside a flat set of points that make the Delaunay triangulation in space a cone over that of the
//       set.
// Law:  the sphere through three points of a plane and any other point cuts the plane in the circle of the three. With
//       one point anywhere beside the plane, the bases of the tetrahedra are the Delaunay triangles of the set, and
//       ties are the same: no point is projected or rounded. With two points beside a line, the tetrahedra contain its
//       edges.
// Cost: linear.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Returns one point outside of the plane if all points are in one plane, two points if all are on one line, and none
/// if the points are in no plane or all equal. The returned points are in the least cube with its center at the origin
/// that contains `points`.
/// Requires: finite points.
std::vector<Point3> beside_flat(std::span<const Point3> points);

}  // namespace rbpa::space

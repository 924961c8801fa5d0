// What: points beside a flat set, one in a plane or on a line, that make the Delaunay triangulation of both a cone over that of the set.
// Law:  the sphere through three points of a plane and any other point cuts the plane in the circle of the three. So of a point beside the plane, wherever it is, the
//       tetrahedra are those on the Delaunay triangles of the set, with the same ties: nothing is projected or rounded. Of two points beside a line likewise, on its
//       edges.
// Cost: linear.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// One point where they are in a plane, two where they are on a line; none where they are not flat, or are equal.
/// Requires: finite points. Both are within twice the greatest coordinate.
std::vector<Point3> beside_flat(std::span<const Point3> points);

}  // namespace rbpa::space

// What: the constrained Delaunay triangulation of polygons, with the points of the polygons as its only corners.
// Law:  the triangles cover the polygons once, and depend on the polygons as point sets alone; otherwise that of
//       constrained_delaunay.h (rbpa/plane/).
// Cost: that of the Delaunay triangulation and of insert_segments().
#pragma once

#include <vector>

#include "rbpa/base/progress.h"
#include "rbpa/base/triangle.h"
#include "rbpa/fill/front/outline.h"

namespace rbpa {

/// Returns the constrained Delaunay triangles of `outline`, counter-clockwise, in no particular order; corners are
/// positions in `outline.places`. Several rings may pass through a place, and two rings may pass through an edge in
/// opposite directions.
/// Requires: distinct places, at most as many as rbpa() accepts, each on a ring; rings that do not cross, and that have
///           every place on their edges as a corner.
/// Throws:   Cancelled.
std::vector<Triangle> triangulate(const Outline& outline, const GoOn& go_on);

}  // namespace rbpa

// What: measures the largest gap between a point and its neighbors, in the plane that fits them.
// Law:  a function of the list of neighbors, in rounded numbers; no exact decision depends on it.
// How:  the plane cuts the Voronoi cell of the point; the corners of the section are the centers of the gaps.
#pragma once

#include <optional>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Returns the distance from the point to the farthest corner of the section: about the circumradius of the largest
/// triangle around the point. Returns nothing if the distance is above `reach`, as at the end of a surface, or if there
/// are fewer than three neighbors.
/// Requires: neighbors relative to the point, none at it, the farthest last; a unit normal; no square overflows or
///           underflows.
std::optional<double> gap_around(std::span<const Point3> neighbors, const Point3& normal, double reach);

/// Returns the circumradius of the point, its first neighbor, and the next neighbor that is not on a line with the two.
/// Returns nothing if all neighbors are on a line with the point.
std::optional<double> nearest_circumradius(std::span<const Point3> neighbors);

}  // namespace rbpa::space

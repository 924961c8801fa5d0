// What: the largest gap between a point and its neighbors, in the plane that fits them.
// Law:  a function of the list of neighbors, in rounded numbers; no exact decision depends on it.
// How:  cut the point's Voronoi cell with the plane: the corners are the centers of the gaps.
#pragma once

#include <optional>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// The distance to the farthest corner of the cell: about the circumradius of the largest triangle around the point. Nothing
/// where that is beyond `reach`, as at the end of a surface.
/// Requires: neighbors relative to the point, none at it, the farthest last; a unit normal; no square overflows or underflows.
std::optional<double> gap_around(std::span<const Point3> neighbors, const Point3& normal, double reach);

/// The circumradius of the point, its first neighbor, and the next one that is not on a line with these; nothing where all
/// are.
std::optional<double> nearest_circumradius(std::span<const Point3> neighbors);

}  // namespace rbpa::space

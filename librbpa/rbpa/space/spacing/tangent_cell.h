// What: how large the gaps between a point and its neighbours are, along the plane that fits them.
// How:  the Voronoi cell of the point, cut with that plane: its corners are the centres of the gaps.
// Law:  a function of the list of neighbours; in rounded numbers, and no decision depends on it.
#pragma once

#include <optional>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// The distance of the farthest corner of the cell: nearly the circumradius of the largest triangle around the point. Nothing
/// where that is beyond `reach`, as it is at the end of a surface.
/// Requires: neighbours relative to the point, none at it, the farthest last; a unit normal. Squares neither overflow nor vanish.
std::optional<double> gap_around(std::span<const Point3> neighbors, const Point3& normal, double reach);

/// The circumradius of the point and two neighbours, the first and the next that is not on a line with it and the point; nothing where
/// all are.
std::optional<double> nearest_circumradius(std::span<const Point3> neighbors);

}  // namespace rbpa::space

// What: makes polygons with holes from rings that are not marked as shells or holes.
// Law:  the regions depend on the rings as point sets alone; the order of the polygons follows that of the rings.
// Cost: n log n in the points of the rings.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// Returns the polygons of the rings, with area and perimeter. A ring inside an even number of others is a shell; a
/// ring inside an odd number is a hole of the smallest ring around it. Shells are counter-clockwise and holes
/// clockwise, both in the order of the rings.
/// Throws: InvalidInput that names the place when an index does not exist, coordinates are not finite, a ring has fewer
///         than three points or no area, or the polygons are not valid (validity.h); Cancelled.
RBPA_API std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                                const GoOn& go_on = {});

/// Returns the polygons of rings as polygons_of_rings(points, rings) does. Checks that each hole contains, outside of
/// shells in the hole, one or more points of `in_holes`; files of Shewchuk's Triangle mark holes by such points.
/// Requires: no point of `in_holes` is on a ring; not checked.
/// Throws:   as polygons_of_rings(points, rings) does; InvalidInput when a point of `in_holes` is not finite or is in
///           no hole, or when a hole has no point of `in_holes`.
RBPA_API std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                                std::span<const Point> in_holes, const GoOn& go_on = {});

}  // namespace rbpa

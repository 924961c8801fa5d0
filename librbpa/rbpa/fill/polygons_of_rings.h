// What: makes polygons with holes from rings that are not marked as shells or holes.
// Law:  the regions are a function of the rings as point sets; the order of the polygons follows that of the rings.
// Cost: n log n in the points of the rings.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// Returns the polygons of the rings. A ring inside an even number of others is a shell; inside an odd number, it is a
/// hole of the smallest ring around it. Shells are counter-clockwise and holes clockwise, both in the order of the
/// rings; area and perimeter are computed.
/// Throws: InvalidInput that names the ring and the place, when an index does not exist, coordinates are not finite, a
///         ring has fewer than three points or no area, or the polygons are not valid (validity.h); Cancelled.
RBPA_API std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                                const GoOn& go_on = {});

/// Returns the polygons of rings as polygons_of_rings(points, rings) does, and checks that each hole contains, outside
/// of shells in the hole, one or more of the points `in_holes`, by which files of Shewchuk's Triangle mark holes.
/// Requires: no point of `in_holes` is on a ring; not checked.
/// Throws:   as polygons_of_rings(points, rings); InvalidInput when a point of `in_holes` is not finite or in no hole,
///           or a hole has no such point.
RBPA_API std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                                std::span<const Point> in_holes, const GoOn& go_on = {});

}  // namespace rbpa

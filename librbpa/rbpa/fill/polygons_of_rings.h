// What: makes polygons with holes from rings that are not marked as shells or holes.
// Law:  the polygons are a function of the rings as point sets; their order also depends on the order of the rings.
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
/// rings; measures are filled in.
/// Throws: InvalidInput that names ring and place: as fill(); Cancelled.
RBPA_API std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                                const GoOn& go_on = {});

/// Returns the polygons of rings whose holes are marked by points in them, as in files of Shewchuk's Triangle: each
/// hole contains one or more.
/// Throws: what polygons_of_rings(points, rings) throws; InvalidInput when a point is in no hole, or a hole has no
///         point.
RBPA_API std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                                std::span<const Point> in_holes, const GoOn& go_on = {});

}  // namespace rbpa

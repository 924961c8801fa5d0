// What: polygons with holes from rings that are not marked as shells or holes.
// Law:  the polygons are a function of the rings as point sets; their order also depends on the order of the rings.
// Cost: n log n in the points of the rings.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/shape.h"

namespace rbpa {

/// Rings as polygons with holes: a ring in an even number of others is a shell, in an odd one a hole of the smallest around
/// it. Shells go counter-clockwise and holes clockwise, both in the order of the rings; measures are filled in.
/// Throws: InvalidInput that names ring and place: as fill(); Cancelled.
RBPA_API std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                                const std::function<bool()>& go_on = {});

/// The same where holes are marked by points in them, as in files of Shewchuk's Triangle: each hole has one or more.
/// Throws: moreover InvalidInput when a point is in no hole, or a hole has none.
RBPA_API std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                                std::span<const Point> in_holes,
                                                const std::function<bool()>& go_on = {});

}  // namespace rbpa

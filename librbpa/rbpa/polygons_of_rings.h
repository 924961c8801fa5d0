// What: rings, of which it is not known which are holes, as polygons with holes.
// Law:  a function of the rings as sets of the plane, but for the order of what is returned.
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

/// The same where holes were marked by points in them, as Triangle has it: each hole has one or more.
/// Throws: moreover InvalidInput when a point is in no hole, or a hole has none.
RBPA_API std::vector<Polygon> polygons_of_rings(std::span<const Point> points, std::span<const Ring> rings,
                                                std::span<const Point> in_holes,
                                                const std::function<bool()>& go_on = {});

}  // namespace rbpa

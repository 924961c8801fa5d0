// What: outline_polygons() of a complex that is known to be linked, such as one that was just computed.
#pragma once

#include <span>
#include <vector>

#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// Returns outline_polygons(points, complex, filter), but does not check whether the complex is linked.
/// Requires: as require_linked(), which is not checked.
/// Throws:   InvalidInput when a bound of the filter is negative or not a number; ContractViolation when the points are
///           visibly not those of the complex; Cancelled.
std::vector<Polygon> polygons_of_linked(std::span<const Point> points, const TriangleArrays& complex,
                                        const PolygonFilter& filter, const GoOn& go_on = {});

}  // namespace rbpa

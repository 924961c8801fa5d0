// What: assigns each input point to the polygon that contains it.
// Law:  the result depends on the set of points, alpha and the filter only. A corner of a triangle is in the polygon of
//       its component; an exact plane sweep decides which other points lie in filled holes.
// Cost: linear in the complex; if the filter has a bound on holes, n log n in the boundary and the points in no
//       triangle.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/point.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// Returns for each input point the index of the polygon that contains it, inside or on a ring: the least index if
/// several polygons touch at the point, nothing if no polygon contains it. A duplicate has the polygon of the point
/// that it repeats.
/// Requires: `points` are those of the complex, and `polygons` is the result of outline_polygons(complex, filter); not
///           checked.
/// Throws:   Cancelled.
RBPA_API std::vector<std::optional<std::uint32_t>> polygon_of_points(const SolidAlphaComplex& complex,
                                                                     std::span<const Polygon> polygons,
                                                                     const PolygonFilter& filter,
                                                                     std::span<const Point> points,
                                                                     const GoOn& go_on = {});

/// Returns the polygon of each input point, as the first overload does, for a solid complex in arrays.
/// Requires: neighbors were computed; `duplicates` are those of the complex; `polygons` is the result of
///           outline_polygons(points, complex, filter). None of these is checked.
/// Throws:   Cancelled.
RBPA_API std::vector<std::optional<std::uint32_t>> polygon_of_points(
    std::span<const Point> points, const TriangleArrays& complex, std::span<const Duplicate> duplicates,
    std::span<const Polygon> polygons, const PolygonFilter& filter, const GoOn& go_on = {});

/// Returns the polygon of each of `queries`, some of the input points, as the first overload does, without the complex.
/// Requires: `polygons`, with indices of `corners`, are outline polygons of the input, filtered or not; not checked.
/// Throws:   Cancelled.
/// Cost:     n log n in the corners and the queries.
RBPA_API std::vector<std::optional<std::uint32_t>> polygon_of_points(std::span<const Polygon> polygons,
                                                                     std::span<const Point> corners,
                                                                     std::span<const Point> queries,
                                                                     const GoOn& go_on = {});

}  // namespace rbpa

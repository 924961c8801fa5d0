// What: which polygon each input point is in.
// Law:  a function of the set of points, alpha and the filter. A vertex of the solid is in the polygon of its component;
//       which points lie in filled holes is decided exactly, by a plane sweep.
// Cost: linear in the complex; n log n in the boundary and the points outside the solid, where holes were filled.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/duplicate.h"
#include "rbpa/base/point.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/shape.h"

namespace rbpa {

/// For each input point, the index of the polygon that contains it, inside or on a ring; the least index where several
/// polygons touch in the point; absent where none contains it. A duplicate has the index of the point that it repeats.
/// Requires: `points` are those of the complex, and `polygons` what polygons(complex, filter) returns.
/// Throws: Cancelled when `go_on`, which is called every few milliseconds, returns false. Empty: never called.
RBPA_API std::vector<std::optional<std::uint32_t>> polygon_of_points(const SolidAlphaComplex& complex,
                                                                     std::span<const Polygon> polygons,
                                                                     const PolygonFilter& filter,
                                                                     std::span<const Point> points,
                                                                     const std::function<bool()>& go_on = {});

/// The same of a solid complex in arrays, with neighbors, and the points that repeat others.
RBPA_API std::vector<std::optional<std::uint32_t>> polygon_of_points(
    std::span<const Point> points, const TriangleArrays& complex, std::span<const Duplicate> duplicates,
    std::span<const Polygon> polygons, const PolygonFilter& filter, const std::function<bool()>& go_on = {});

}  // namespace rbpa

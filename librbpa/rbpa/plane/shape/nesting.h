// What: finds the hole in which each polygon lies, and the polygon in which each point lies.
// How:  a sweep over the plane from left to right, decided exactly. Next below a shell's first point is an edge of a
//       hole, an edge of another shell, or nothing; a point lies in a polygon if the polygon is above the edge next
//       below the point.
// Cost: n log n in the boundary edges and the points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

struct HoleOf {
  std::size_t polygon;
  std::size_t hole;
  friend bool operator==(const HoleOf&, const HoleOf&) = default;
};

/// Returns for each polygon the smallest hole that contains the polygon; nothing if no hole does.
/// Requires: `polygons` are those of a solid alpha complex, `points` the input by index.
/// Throws:   Cancelled, from `step`, which counts comparisons of sorts and points of the sweep.
std::vector<std::optional<HoleOf>> nesting(std::span<const Polygon> polygons, std::span<const Point> points,
                                           Steps& step);

/// Returns for each of `queries` the polygon that contains the point; nothing if no polygon does.
/// Requires: as nesting(); no query is on a ring.
/// Throws:   as nesting().
std::vector<std::optional<std::uint32_t>> polygons_around(std::span<const Polygon> polygons,
                                                          std::span<const Point> points, std::span<const Point> queries,
                                                          Steps& step);

}  // namespace rbpa

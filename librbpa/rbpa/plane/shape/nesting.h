// What: which polygon lies in a hole of which, and which points lie in polygons.
// How:  a sweep over the plane from left to right, exactly decided: below a shell's first point there is a hole, or a
//       shell beside it, or nothing; the edge below a point has the polygon around it above it, or none.
// Cost: n log n in the boundary edges and the points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/steps.h"
#include "rbpa/shape.h"

namespace rbpa {

struct HoleOf {
  std::size_t polygon;
  std::size_t hole;
  friend bool operator==(const HoleOf&, const HoleOf&) = default;
};

/// For each polygon the smallest hole that it lies in, if any.
/// Requires: `polygons` are those of a solid alpha complex, `points` the input by index.
/// Throws: Cancelled. What is sorted and every point of the sweep are steps; so below.
std::vector<std::optional<HoleOf>> nesting(std::span<const Polygon> polygons, std::span<const Point> points,
                                           Steps& step);

/// For each of `queries`, indices of points, the polygon that it lies in, if any.
/// Requires: the same, and no query on a ring.
std::vector<std::optional<std::uint32_t>> polygons_around(std::span<const Polygon> polygons,
                                                          std::span<const Point> points,
                                                          std::span<const std::uint32_t> queries, Steps& step);

}  // namespace rbpa

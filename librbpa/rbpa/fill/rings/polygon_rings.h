// What: the rings of polygons, checked for validity under OGC Simple Features.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/fill/rings/noded_rings.h"
#include "rbpa/fill/rings/simple_rings.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

/// The role of an input ring: the shell of a polygon, or one of its holes.
struct RingRole {
  std::size_t polygon;
  std::optional<std::size_t> hole;
};

/// The rings of all polygons, one polygon after the other, the shell first.
struct PolygonRings {
  std::vector<Ring> input = {};
  std::vector<RingRole> roles = {};
  std::vector<std::size_t> groups = {};  ///< the group of each ring, ascending
  NodedRings noded = {};
  std::vector<RingPlace> places = {};
};

/// Returns the rings after checking that the polygons of each group, which begin at the positions in `groups` (fill.h),
/// are a valid multipolygon. Different groups may meet, which is not checked; but vertices of other groups on the edges
/// of a group become its own.
/// Throws: InvalidInput that names what is not valid, and where; Cancelled.
PolygonRings valid_polygons(std::span<const Point> points, std::span<const Polygon> polygons,
                            std::span<const std::size_t> groups, const GoOn& go_on);

}  // namespace rbpa

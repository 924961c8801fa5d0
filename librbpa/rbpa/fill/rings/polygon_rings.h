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

/// The role of an input ring: the shell of a polygon if `hole` is absent, otherwise hole number `hole` of the polygon.
struct RingRole {
  std::size_t polygon;
  std::optional<std::size_t> hole;
};

/// The rings of all polygons, one polygon after another, the shell of each first.
struct PolygonRings {
  std::vector<Ring> input = {};
  std::vector<RingRole> roles = {};
  std::vector<std::size_t> groups = {};  ///< the group of each ring, ascending
  NodedRings noded = {};
  std::vector<RingPlace> places = {};
};

/// Checks that the polygons of each group are a valid multipolygon, and returns their rings. `groups` has the number
/// of the first polygon of each group, as FillOptions::groups has. Rings of different groups may cross and overlap; a
/// vertex of one group on an edge of another becomes a vertex of that edge's ring.
/// Throws: InvalidInput that names the invalid ring or group, and the place; Cancelled.
PolygonRings valid_polygons(std::span<const Point> points, std::span<const Polygon> polygons,
                            std::span<const std::size_t> groups, const GoOn& go_on);

}  // namespace rbpa

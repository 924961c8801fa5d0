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

/// The role of an input ring: the shell of a polygon, where `hole` is absent, or a hole of a polygon, by its number.
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

/// Returns the rings after checking that the polygons of each group are a valid multipolygon. `groups` has the number
/// of the first polygon of each group, as FillOptions::groups. Different groups may meet, which is not checked;
/// vertices of one group on an edge of another become vertices of that edge's ring.
/// Throws: InvalidInput that names the invalid ring or group, and the place; Cancelled.
PolygonRings valid_polygons(std::span<const Point> points, std::span<const Polygon> polygons,
                            std::span<const std::size_t> groups, const GoOn& go_on);

}  // namespace rbpa

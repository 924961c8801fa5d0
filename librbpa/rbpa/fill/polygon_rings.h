// What: the rings of polygons, checked: valid under OGC Simple Features.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/fill/noded_rings.h"
#include "rbpa/fill/simple_rings.h"
#include "rbpa/shape.h"

namespace rbpa {

/// Where a ring of the input is: the shell of a polygon, or one of its holes.
struct RingRole {
  std::size_t polygon;
  std::optional<std::size_t> hole;
};

/// The rings of all polygons, a polygon's one behind the other, the shell first.
struct PolygonRings {
  std::vector<Ring> input = {};
  std::vector<RingRole> roles = {};
  std::vector<std::size_t> groups = {};  ///< for each ring, ascending
  NodedRings noded = {};
  std::vector<RingPlace> places = {};
};

/// The polygons of each group, which begin at the positions in `groups` (fill.h), are a valid multipolygon. Whether a group
/// meets others is not checked; but vertices of others on its edges become its own.
/// Throws: InvalidInput that names what is not valid, and where; Cancelled.
PolygonRings valid_polygons(std::span<const Point> points, std::span<const Polygon> polygons,
                            std::span<const std::size_t> groups, const std::function<bool()>& go_on);

}  // namespace rbpa

// What: polygons of points, and what is known of both, for the files that are made of them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "io/crs.h"
#include "rbpa/base/point.h"
#include "rbpa/shape.h"

namespace rbpa::app {

struct Shape {
  std::span<const Point> points;
  std::span<const Polygon> polygons;
  /// For each point the index of the polygon that it is in, if any.
  std::span<const std::optional<std::uint32_t>> polygon_of;
  std::optional<Crs> crs = std::nullopt;  ///< where it is known
  bool degrees = false;                   ///< the points are longitudes and latitudes, whatever is known of the crs
};

/// How many points are in each polygon: each point counts in one.
std::vector<std::size_t> points_in_polygons(const Shape& shape);

}  // namespace rbpa::app

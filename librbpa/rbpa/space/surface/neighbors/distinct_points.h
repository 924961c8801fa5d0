// What: finds the distinct points among points in space, and scales points so that squares of coordinates fit double.
// Cost: a sort.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// The distinct points, ascending, and the position of each input point among them.
struct DistinctPoints {
  std::vector<Point3> points;
  std::vector<std::uint32_t> number;
};

DistinctPoints distinct_points(std::span<const Point3> points);

/// Multiplies the points by a power of two such that squares of their coordinates neither overflow nor underflow.
/// Returns the exponent of the power. Returns nothing, and changes no point, if there is no such power.
std::optional<int> fit_double(std::vector<Point3>& points);

}  // namespace rbpa::space

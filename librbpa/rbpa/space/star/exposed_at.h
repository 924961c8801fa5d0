// What: the exposed triangles at some points of many, without those elsewhere.
// Law:  exposed_triangles() has the same, and rolls between them in the same way.
// Cost: that of the rings of these points, and of the cells of all.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa::space {

/// The exposed triangle (at, second, third), counter-clockwise; over its side from `third` to `at` the ball rolls to the triangle
/// (at, third, beyond).
struct ExposedAt {
  std::uint32_t at, second, third, beyond;
  friend auto operator<=>(const ExposedAt&, const ExposedAt&) = default;
};

/// Those at points with wanted[i] != 0, sorted; of equal points the lowest decides, and stands for them.
/// Requires: as exposed_triangles(). Throws: Cancelled.
std::vector<ExposedAt> exposed_at(std::span<const Point3> points, double radius,
                                  const std::vector<std::uint8_t>& wanted, const SurfaceOptions& options);

}  // namespace rbpa::space

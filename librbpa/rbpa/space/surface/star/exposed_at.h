// What: finds the exposed triangles at wanted points among many.
// Law:  the triangles, and the rolls between them, are those of exposed_triangles().
// Cost: that of the rings of the wanted points, and of the cells of all points.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::space {

/// An exposed triangle (at, second, third), counter-clockwise. Over its side from `third` to `at` the ball rolls to the
/// triangle (at, third, beyond).
struct ExposedAt {
  std::uint32_t at, second, third, beyond;
  friend auto operator<=>(const ExposedAt&, const ExposedAt&) = default;
};

/// Returns the exposed triangles at points i with wanted[i] != 0, sorted. Of equal points, the one of lowest index
/// decides, and stands for the others.
/// Requires: what exposed_triangles() requires. Throws: Cancelled.
std::vector<ExposedAt> exposed_at(std::span<const Point3> points, double radius,
                                  const std::vector<std::uint8_t>& wanted, const SurfaceOptions& options);

}  // namespace rbpa::space

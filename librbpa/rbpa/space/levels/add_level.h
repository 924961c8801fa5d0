// What: one more radius: the triangles that it adds to a surface of smaller radii.
// Law:  at a point that is open the result has the triangles and the gluing that surface() by all these radii has there.
// Cost: that of surface() of the points near those that are open and not interior; a sort of the triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa::space {

/// Triangles get `number` as their level, more than the surface has. Of a point that is not open the triangles that it shares with
/// no open point may be wrong.
/// Requires: a surface with levels, sorted as surface() has it; of each point whether it is open, of equal ones the first decides.
void add_level(std::span<const Point3> points, std::span<const Point3> normals, std::uint32_t number, double radius,
               std::vector<std::uint8_t> open, Surface& surface, const SurfaceOptions& options);

}  // namespace rbpa::space

// What: adds the triangles of one more radius to a surface of smaller radii.
// Law:  the result at an open point has the triangles and the gluing of surface() by the smaller radii and this one.
// Cost: that of surface() for the points near open points that are not interior; a sort of the triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::space {

/// Adds the triangles of `radius` with level `number`. Triangles without an open corner may be missing or wrong.
/// Requires: `surface` has levels below `number`, and is sorted as surface() sorts it; `open` has for each point
///           whether the point is open; the first of equal points decides for all.
void add_level(std::span<const Point3> points, std::span<const Point3> normals, std::uint32_t number, double radius,
               std::vector<std::uint8_t> open, Surface& surface, const SurfaceOptions& options);

}  // namespace rbpa::space

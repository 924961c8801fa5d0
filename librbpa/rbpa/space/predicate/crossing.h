// What: whether triangles in space, or a segment and a triangle, cross: they have more in common than corners and sides.
// Law:  exact for every finite input. Corners are common when they are equal as points.
// Cost: tens of nanoseconds where a plane parts them.
#pragma once

#include <array>

#include "rbpa/base/point3.h"

namespace rbpa::space {

using Corners = std::array<Point3, 3>;

/// Neither a common corner nor a common side is all that the triangles have in common: they overlap, one pierces the other, or
/// they touch anywhere else.
/// Requires: triangles with an area.
bool triangles_cross(const Corners& s, const Corners& t);

/// The segment from p to q meets the triangle elsewhere than in ends that are corners of the triangle, or is one of its sides.
/// Requires: p != q, a triangle with an area.
bool segment_crosses(const Point3& p, const Point3& q, const Corners& t);

}  // namespace rbpa::space

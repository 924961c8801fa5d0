// What: tests whether two triangles in space, or a segment and a triangle, meet outside of shared corners and sides.
// Law:  exact for every finite input. A corner is shared if it is an equal point.
// Cost: tens of nanoseconds if the plane of a triangle separates the two.
#pragma once

#include <array>
#include <span>

#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"

namespace rbpa::space {

using Corners = std::array<Point3, 3>;

/// Returns the corners of a triangle, rotated so that the least point is first. The result does not depend on indices.
inline Corners corners_of(std::span<const Point3> points, const Triangle& triangle) {
  const Point3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  if (b < a && !(c < b)) return {b, c, a};
  if (c < a && c < b) return {c, a, b};
  return {a, b, c};
}

/// Returns whether the triangles cross: whether they have a common point that is not a shared corner or on a shared
/// side. Equal triangles cross.
/// Requires: both triangles have an area.
bool triangles_cross(const Corners& s, const Corners& t);

/// Returns whether the segment from p to q meets the triangle anywhere except in an end that is a corner of the
/// triangle. A segment that is a side of the triangle crosses it.
/// Requires: p != q, a triangle with an area.
bool segment_crosses(const Point3& p, const Point3& q, const Corners& t);

}  // namespace rbpa::space

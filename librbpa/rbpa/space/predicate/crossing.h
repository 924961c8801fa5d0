// What: tests whether two triangles in space, or a segment and a triangle, cross: share more than corners and sides.
// Law:  exact for every finite input. Corners are shared when they are equal as points.
// Cost: tens of nanoseconds where a plane separates them.
#pragma once

#include <array>
#include <span>

#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"

namespace rbpa::space {

using Corners = std::array<Point3, 3>;

/// Returns the corners of a triangle, the least point first: the result does not depend on the numbers of points.
inline Corners corners_of(std::span<const Point3> points, const Triangle& triangle) {
  const Point3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  if (b < a && !(c < b)) return {b, c, a};
  if (c < a && c < b) return {c, a, b};
  return {a, b, c};
}

/// Returns whether the triangles cross: whether they overlap, one pierces the other, or they touch anywhere except in a
/// shared corner or along a shared side.
/// Requires: triangles with an area.
bool triangles_cross(const Corners& s, const Corners& t);

/// Returns whether the segment from p to q meets the triangle anywhere except in an end that is a corner of the
/// triangle. A segment that is a side of the triangle crosses it.
/// Requires: p != q, a triangle with an area.
bool segment_crosses(const Point3& p, const Point3& q, const Corners& t);

}  // namespace rbpa::space

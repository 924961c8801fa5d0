// What: tests whether a ray along x from within a tetrahedron crosses a triangle.
// Law:  exact on any finite input. The ray begins at the first corner, moved into the tetrahedron by infinitesimals: it
//       thus passes through no point, and through no edge except one along the ray.
// Cost: a few orientations, where the bounding boxes overlap in y and z.
#pragma once

#include <algorithm>
#include <array>

#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {

/// Returns 1 if the ray from within tetrahedron `from` crosses the triangle from behind, −1 from the front, else 0.
/// Requires: the tetrahedron is not flat.
inline int ray_crossing(const std::array<Point3, 3>& triangle, const std::array<Point3, 4>& from) {
  const auto& [a, b, c] = triangle;
  const auto [low_y, high_y] = std::minmax({a.y, b.y, c.y});
  if (from[0].y < low_y || from[0].y > high_y) return 0;
  const auto [low_z, high_z] = std::minmax({a.z, b.z, c.z});
  if (from[0].z < low_z || from[0].z > high_z) return 0;
  // The ray begins at p + ε q + ε² r + ε³ s for corners p, q, r, s: the first corner that is not on the line decides.
  const auto side_of_line = [&](const Point3& u, const Point3& v) {
    for (const Point3& p : from)
      if (const int side = orientation_along(u, v, p, 0); side != 0) return side;
    return 0;
  };
  const int first = side_of_line(a, b);
  if (first == 0 || side_of_line(b, c) != first || side_of_line(c, a) != first) return 0;
  // The triangle is ahead of the ray if the beginning is on the side of the plane from which the ray comes.
  for (const Point3& p : from)
    if (const int side = orientation(a, b, c, p); side != 0) return side == -first ? first : 0;
  return 0;
}

}  // namespace rbpa::space

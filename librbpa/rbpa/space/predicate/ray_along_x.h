// What: tests whether a ray from a point in the direction of x crosses a triangle.
// Law:  exact for every finite input. The ray counts as moved by an infinitesimal in y and a smaller one in z, which
//       decides if the ray touches a side.
// Cost: that of four orientations.
#pragma once

#include <array>

#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {

/// Returns the side of the line pq, seen along x, on which the moved ray passes. `side` is the side of the ray that is
/// not moved, and is the result unless it is 0. Returns 0 only if pq is along x.
inline int moved_side(int side, const Point3& p, const Point3& q) {
  if (side != 0) return side;
  if (p.z != q.z) return p.z < q.z ? -1 : 1;
  if (p.y != q.y) return p.y < q.y ? 1 : -1;
  return 0;
}

/// Returns 1 if the ray from `at` crosses the triangle from behind, −1 if from the front, 0 if not at all.
inline int crossing(const std::array<Point3, 3>& t, const Point3& at) {
  const auto side = [&](std::size_t i, std::size_t j) {
    return moved_side(orientation_along(t[i], t[j], at, 0), t[i], t[j]);
  };
  const int first = side(0, 1);
  if (first == 0 || side(1, 2) != first || side(2, 0) != first) return 0;
  // The triangle is ahead of `at` if `at` is on the side of the plane from which the ray comes.
  return orientation(t[0], t[1], t[2], at) == -first ? first : 0;
}

}  // namespace rbpa::space

// What: scales the rim of a hole so that no computation with it underflows or overflows.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/space/cells/box_scale.h"
#include "rbpa/space/cells/box_tree.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

using Vector = Vector3<double>;

inline Vector operator-(const Vector& u, const Vector& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }

/// The greatest turn of a surface over an edge. The turn is |n − n'|² for the unit normals n and n' on both sides: 0
/// where the surface is flat, 4 where it is folded back, ascending with the angle. Angles below 0.0035 degrees count as
/// flat. The code uses no function that processors or libraries may round differently.
inline constexpr float most_turn = 4;
inline float turn_between(const Vector& unit, const Vector& other) {
  constexpr double flat = 0x1p-28;
  const Vector d = unit - other;
  const double turn = dot(d, d);
  return turn < flat ? 0 : turn < 4 ? static_cast<float>(turn) : most_turn;
}

/// The rim of a hole, with the hole to its left. No two corners are at one point.
struct Rim {
  std::vector<Point3> points;
  std::vector<Vector> places;  ///< the points, scaled to a box of side 1
  /// Unit normal of the triangle at the edge from each corner to the next; 0 if the triangle has no area.
  std::vector<Vector> normals;
  int exponent = 0;  ///< one unit of `places` is 2^exponent units of `points`

  /// Scales the corners. `across` has, for each edge, the third corner of the triangle at that edge.
  Rim(std::span<const Point3> corners, std::span<const Point3> across) : points(corners.begin(), corners.end()) {
    Box box;
    for (const Point3& p : corners) box.include(p);
    for (const Point3& p : across) box.include(p);
    const BoxScale scale(box.low, box.high);
    exponent = scale.exponent();
    for (const Point3& p : points) places.push_back(scale.place(p));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector &from = places[i], &to = places[(i + 1) % points.size()];
      const Vector n = cross(from - to, scale.place(across[i]) - to);
      const double length = std::sqrt(dot(n, n));
      normals.push_back(length > 0 ? Vector{n.x / length, n.y / length, n.z / length} : Vector{0, 0, 0});
    }
  }

  std::size_t size() const { return points.size(); }
};

}  // namespace rbpa::space

// What: expresses vectors as numbers of edges of a cell that repeats.
// Cost: constant.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "rbpa/space/balls/periodic/torus_rank.h"
#include "rbpa/space/balls/periodic_balls.h"
#include "rbpa/space/predicate/vector3.h"

namespace rbpa::space {

/// Returns p moved by numbers of edges.
inline Point3 moved(Point3 p, const std::array<Point3, 3>& edges, const Boxes& offset) {
  for (const auto c : {&Point3::x, &Point3::y, &Point3::z})
    for (std::size_t k = 0; k < 3; ++k) p.*c += offset[k] * (edges[k].*c);
  return p;
}

class CellAxes {
 public:
  static constexpr std::int32_t most_layers = 100;  ///< of images on each side of a cell

  /// Throws InvalidInput unless the edges are finite, and have a volume within the range of double.
  explicit CellAxes(const RepeatingCell& cell);

  /// Returns the number of edges of each kind in p, as seen from the origin; rounded.
  std::array<double, 3> along(const Point3& p) const {
    return {dot(normals_[0], {p.x, p.y, p.z}), dot(normals_[1], {p.x, p.y, p.z}), dot(normals_[2], {p.x, p.y, p.z})};
  }
  /// Returns the number of whole edges in `along`, the coordinate of center i along an edge. Throws InvalidInput that
  /// names the center unless the number is below 2^30.
  static std::int32_t whole(double along, std::size_t i);
  /// Returns the reciprocal of the distance between the faces of the cell that edge k connects.
  double per_length(std::size_t k) const { return norm(normals_[k]); }

 private:
  static double norm(const Vector3<double>& v) { return std::sqrt(dot(v, v)); }

  std::array<Vector3<double>, 3> normals_{};  // the product of normal k with a vector is the number of edges k in it
};

}  // namespace rbpa::space

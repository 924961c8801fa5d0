// What: the exposed triangles by CGAL: its Delaunay triangulation in space, with the closed alpha complex by exact
//       radii; and its own Fixed alpha shape.
// Law:  shares nothing with the library: the definition by the complex, not by balls.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "support/triangle.h"

namespace rbpa_test {

/// E_r, and how its triangles are glued: canonical triangles by the lowest input indices; of each, neighbor k is the one
/// across from corner k.
struct ExposedByCgal {
  /// What stands for a neighbor where there is none.
  static constexpr std::uint32_t none = 0xffffffff;
  std::vector<Triangle> triangles, neighbors;
};

/// Of the closed alpha complex in the Delaunay triangulation. Requires: finite points.
ExposedByCgal exposed_by_delaunay(std::span<const rbpa::Point3> points, double radius);

/// Of these triangles those that agree with the normals of all points at their corners, and what is glued among them.
ExposedByCgal agreeing(const ExposedByCgal& exposed, std::span<const rbpa::Point3> points,
                       std::span<const rbpa::Point3> normals);

/// The exposed triangles that Fixed_alpha_shape_3 calls regular (once, oriented outward) and singular (twice).
std::vector<Triangle> exposed_by_alpha_shape(std::span<const rbpa::Point3> points, double radius);

}  // namespace rbpa_test

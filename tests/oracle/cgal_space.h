// What: the exposed triangles by CGAL: by its Delaunay triangulation in space, with the closed alpha complex by exact
//       radii; and by its own Fixed alpha shape.
// Law:  shares no code with the library, and defines exposed triangles by the complex, not by balls.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "support/triangle.h"

namespace rbpa_test {

/// The exposed triangles E_r, and how they are glued: canonical triangles by the lowest input indices; neighbor k of a
/// triangle is the one across from corner k.
struct ExposedByCgal {
  /// Stands for a missing neighbor.
  static constexpr std::uint32_t none = 0xffffffff;
  std::vector<Triangle> triangles, neighbors;
};

/// Returns the exposed triangles of the closed alpha complex in the Delaunay triangulation. Requires: finite points.
ExposedByCgal exposed_by_delaunay(std::span<const rbpa::Point3> points, double radius);

/// Returns those of the exposed triangles that agree with the normals at all their corners, and how these are glued.
ExposedByCgal agreeing(const ExposedByCgal& exposed, std::span<const rbpa::Point3> points,
                       std::span<const rbpa::Point3> normals);

/// Returns the exposed triangles that Fixed_alpha_shape_3 calls regular (once, oriented outward) and singular (twice).
std::vector<Triangle> exposed_by_alpha_shape(std::span<const rbpa::Point3> points, double radius);

}  // namespace rbpa_test

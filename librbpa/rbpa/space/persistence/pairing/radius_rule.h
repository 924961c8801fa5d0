// What: decides at which radius triangles and edges of a Delaunay triangulation enter the full alpha complex, as a rule
//       for values_of_faces.h: a point inside the least sphere of a face conflicts. Radii are rounded up.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994), section 4.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/predicate/least_sphere.h"

namespace rbpa::space {

/// The rule of least spheres: the value of a face is the radius of its least sphere.
class RadiusRule {
 public:
  explicit RadiusRule(std::span<const Point3> points) : points_(points) {}

  struct Face {
    std::span<const Point3> points;
    LeastSphere sphere;
    bool conflicts(std::uint32_t corner) const { return sphere.has_inside(points[corner]); }
    double value() const { return sphere.radius_rounded_up(); }
  };
  Face triangle(const Triangle& corners) const {
    return {points_, {points_[corners[0]], points_[corners[1]], points_[corners[2]]}};
  }
  /// Returns the bits of values_of_faces.h, at most one: only one corner can be inside the least sphere of the others.
  std::uint8_t conflicts(const Triangle& corners) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (in_least_sphere(points_[corners[(k + 1) % 3]], points_[corners[(k + 2) % 3]], points_[corners[k]]))
        return static_cast<std::uint8_t>(1u << k);
    return 0;
  }
  double value(const std::array<std::uint32_t, 2>& edge) const {
    return least_radius_rounded_up(points_[edge[0]], points_[edge[1]]);
  }

 private:
  std::span<const Point3> points_;
};

}  // namespace rbpa::space

// What: computes the radius at which each triangle of a Delaunay triangulation enters the full alpha complex.
// How:  values_of_faces.h with the rule of least spheres: a point inside the sphere conflicts. Radii are rounded up.
// Cost: linear; shared among threads.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994), section 4.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/persistence/pairing/number_faces.h"
#include "rbpa/space/predicate/least_sphere.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// The rule of least spheres for values_of_faces.h: the value of a face is the radius of its least sphere.
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

/// Returns the radius of each of `triangles`. Requires: `delaunay` is solid() of `points` at infinity, with neighbors;
/// `radii` are its circumradii(), and `triangles` its number_triangles().
std::vector<double> triangle_radii(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                                   const NumberedTriangles& triangles, Threads& threads, const GoOn& go_on);

}  // namespace rbpa::space

// What: the power cells of balls: the cell that has a point, and what balls leave of a triangle.
// How:  cells cut the triangle into convex polygons, each of which one disc covers in part. They are found from one to
//       the next, across the sides of the polygons.
// Law:  sizes are rounded; a cell that meets the triangle in a tiny piece may be left out.
// Cost: the neighbors in the triangulation of all cells that meet the triangle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/triangle.h"
#include "rbpa/space/balls/full/edges.h"
#include "rbpa/space/predicate/orthosphere.h"

namespace rbpa::space {

struct Slice {
  double area = 0;       ///< of the triangle
  double outside = 0;    ///< area outside of all balls
  double perimeter = 0;  ///< length of the arcs within the triangle that are on the surface of the union
};

/// The power cells of the balls at the vertices of their regular triangulation. Refers to the stars and tetrahedra.
struct PowerCells {
  std::vector<Ball> balls;
  std::span<const std::array<std::uint32_t, 4>> simplices;
  const PointStars& stars;

  double power(const Point3& x, std::uint32_t i) const;
  /// Returns a ball of least power at x, up to rounding; `start` is any corner of a tetrahedron.
  std::uint32_t ball_at(const Point3& x, std::uint32_t start) const;
  /// Measures the triangle of the centers of three corners of a tetrahedron: 0 if its area is below 2⁻⁴⁰⁰.
  Slice slice(const Triangle& corners) const;
};

}  // namespace rbpa::space

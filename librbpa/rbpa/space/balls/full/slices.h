// What: finds the power cell of balls that contains a point, and measures the part of a triangle outside of balls.
// How:  power cells cut the triangle into convex polygons; in each, only the disc of the cell's ball counts. The cells
//       are found one from another, across the sides of the polygons.
// Law:  sizes are rounded; a cell that meets the triangle in a tiny piece may be left out.
// Cost: linear in the neighbors of all cells that meet the triangle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/triangle.h"
#include "rbpa/space/balls/full/edges.h"
#include "rbpa/space/predicate/orthosphere.h"

namespace rbpa::space {

struct Slice {
  double area = 0;       ///< area of the triangle
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
  /// Measures the triangle of the centers of three corners of a tetrahedron; all 0 if its area is below 2⁻⁴⁰⁰.
  Slice slice(const Triangle& corners) const;
};

}  // namespace rbpa::space

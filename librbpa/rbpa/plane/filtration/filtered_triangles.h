// What: corners and areas of the triangles of a filtration, and a check that a filtration belongs to a triangulation.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "meshops/core/contract.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/filtration.h"

namespace rbpa {

using Corners = std::array<Point, 3>;

inline Corners corners_of(std::span<const Point> points, const Triangle& triangle) {
  return {points[triangle[0]], points[triangle[1]], points[triangle[2]]};
}

/// Returns the area of a triangle, rounded in the same way for every order of the corners; long double, as products of
/// two coordinates may exceed double.
inline long double area(Corners corners) {
  std::sort(corners.begin(), corners.end());
  const auto& [a, b, c] = corners;
  using Wide = long double;
  const Wide cross =
      (Wide(b.x) - Wide(a.x)) * (Wide(c.y) - Wide(a.y)) - (Wide(b.y) - Wide(a.y)) * (Wide(c.x) - Wide(a.x));
  return std::abs(cross) / 2;
}

/// Checks that `filtration` can be the filtration of `delaunay`, by the numbers of triangles and of distinct points.
/// Throws: ContractViolation, whose message begins with `function`, when the filtration is visibly of another
///         triangulation.
inline void require_same(const Filtration& filtration, const AlphaComplex& delaunay, const std::string& function) {
  if (filtration.triangle_alpha.size() != delaunay.triangles.size() || filtration.distinct != delaunay.distinct)
    throw meshops::ContractViolation(
        function + ": found the filtration of another triangulation, expected filtration() of the given one");
}

}  // namespace rbpa

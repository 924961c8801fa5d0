// What: the requirements on a Delaunay triangulation as an input, and the corners and areas of its triangles.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "rbpa/base/point.h"
#include "rbpa/filtration.h"
#include "rbpa/triangulate.h"

namespace rbpa {

using Corners = std::array<Point, 3>;

inline Corners corners_of(std::span<const Point> points, const Triangle& triangle) {
  return {points[triangle[0]], points[triangle[1]], points[triangle[2]]};
}

/// Of corners in any order, always rounded alike; long double, as it is a product of two coordinates.
inline long double area(Corners corners) {
  std::sort(corners.begin(), corners.end());
  const auto& [a, b, c] = corners;
  using Wide = long double;
  const Wide cross =
      (Wide(b.x) - Wide(a.x)) * (Wide(c.y) - Wide(a.y)) - (Wide(b.y) - Wide(a.y)) * (Wide(c.x) - Wide(a.x));
  return std::abs(cross) / 2;
}

/// Throws ContractViolation, which begins with `function`, when `delaunay` is visibly not the Delaunay triangulation of the
/// points with neighbours: numbers do not fit, or triangles turn right.
/// Cost: linear.
void require_delaunay(const Triangulation& delaunay, std::span<const Point> points, const char* function,
                      const std::function<bool()>& go_on);

/// Throws ContractViolation, which begins with `function`, when the filtration is visibly of another triangulation.
void require_same(const Filtration& filtration, const Triangulation& delaunay, const char* function);

}  // namespace rbpa

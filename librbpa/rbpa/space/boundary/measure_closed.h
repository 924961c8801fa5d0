// What: volume, area and box of what closed triangles enclose.
// Law:  sums are exact and rounded once, so that no order matters; solid_boundary.h has the bounds.
// Cost: linear, about twenty products of extended precision a triangle.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"

namespace rbpa::space {

struct ClosedMeasures {
  double volume = 0;  ///< negative where the triangles face what they enclose
  double area = 0;
  Point3 low, high;               ///< opposite corners of the box
  std::array<Point3, 3> least{};  ///< triangle, from its least corner on: by coordinates, so that no numbering matters
};

/// Of some of the triangles, by number. Requires: at least one; together they are closed.
ClosedMeasures measure_closed(std::span<const Point3> points, std::span<const Triangle> triangles,
                              std::span<const std::uint32_t> which);

}  // namespace rbpa::space

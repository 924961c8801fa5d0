// What: gives a common view of triangulations of points and of periodic boxes, for functions that take either.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rbpa/base/point3.h"
#include "rbpa/space/solid/periodic_solid.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// The tetrahedra of a triangulation; corners are vertices. Refers to the arrays of its argument.
struct Triangulated {
  std::span<const Point3> positions;  ///< position of each vertex
  std::span<const std::array<std::uint32_t, 4>> simplices, neighbors;
  /// In a periodic box, the point and offset of each vertex. Otherwise empty: vertices are points.
  std::span<const PeriodicVertex> vertices = {};

  /// Makes a view of a Solid or a RegularTriangulation.
  template <typename Triangulation>
  Triangulated(std::span<const Point3> points, const Triangulation& cells)
      : positions(points), simplices(cells.simplices), neighbors(cells.neighbors) {}
  explicit Triangulated(const PeriodicSolid& solid)
      : positions(solid.positions), simplices(solid.simplices), neighbors(solid.neighbors), vertices(solid.vertices) {}

  std::uint32_t point(std::uint32_t vertex) const { return vertices.empty() ? vertex : vertices[vertex].point; }
  const Point3& position(std::uint32_t t, std::size_t k) const { return positions[simplices[t][k]]; }
};

}  // namespace rbpa::space

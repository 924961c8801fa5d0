// What: the topology of a surface of points in space, from its arrays, and its shells.
// Law:  a function of the triangles and how they are glued; every fan of triangles at a point counts as a vertex.
// Cost: linear, and a sort of the components.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa::app {

struct SurfaceCounts {
  std::size_t triangles = 0;
  std::size_t points = 0;    ///< of the input that are in a triangle
  std::size_t vertices = 0;  ///< fans
  std::size_t edges = 0;
  std::size_t boundary_curves = 0;
  std::size_t components = 0;
  std::size_t genus = 0;  ///< of all components
};

SurfaceCounts count(const Surface& surface);

/// The triangles by components that are glued: the one with the largest box first, of equal boxes the one that encloses
/// more; triangles within a component, and components without such a difference, in the order of the surface.
std::vector<std::array<std::uint32_t, 3>> by_shells(std::span<const Point3> points, const Surface& surface);

}  // namespace rbpa::app

// What: counts the topology of a triangle surface in space from its arrays, and orders the triangles by shells.
// Law:  results depend only on the triangles and their gluing. Each fan of triangles at a point is a vertex.
// Cost: linear; by_shells() also sorts the triangles, non_manifold_edges() their sides.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/space/surface/split_fans.h"
#include "rbpa/space/surface/surface_components.h"

namespace rbpa::app {

struct SurfaceCounts {
  std::size_t triangles = 0;
  std::size_t points = 0;    ///< number of input points that are a corner of a triangle
  std::size_t vertices = 0;  ///< number of fans
  std::size_t touching = 0;  ///< number of points with several fans, where the surface touches itself
  std::size_t edges = 0;
  std::size_t boundary_curves = 0;
  std::size_t components = 0;
  std::size_t genus = 0;  ///< sum over all components
};

/// Returns the counts of a surface. Requires: `fans` and `components` belong to the same surface.
SurfaceCounts count(const SplitFans& fans, const SurfaceComponents& components);

/// Returns the number of non-manifold edges: pairs of points that are corners of more than two triangles. The gluing of
/// the triangles does not matter.
std::size_t non_manifold_edges(std::span<const std::array<std::uint32_t, 3>> triangles);

/// Returns the numbers of the triangles, sorted by component: the component whose box has the longest diagonal first;
/// among equal diagonals, the component with the greater volume. Components that are equal in both are in the order of
/// their first triangles, and triangles of one component keep their order.
std::vector<std::uint32_t> by_shells(const SurfaceComponents& components);

}  // namespace rbpa::app

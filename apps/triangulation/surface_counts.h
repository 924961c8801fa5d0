// What: counts the topology of a surface of points in space from its arrays, and orders its shells.
// Law:  results depend only on the triangles and how they are glued; each fan of triangles at a point is a vertex.
// Cost: linear, and a sort of the triangles by shells.
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
  std::size_t points = 0;    ///< points of the input that are in a triangle
  std::size_t vertices = 0;  ///< number of fans
  std::size_t touching = 0;  ///< points with several fans, where the surface touches itself
  std::size_t edges = 0;
  std::size_t boundary_curves = 0;
  std::size_t components = 0;
  std::size_t genus = 0;  ///< sum over all components
};

/// Returns the counts. Requires: `fans` and `components` are of the same surface.
SurfaceCounts count(const SplitFans& fans, const SurfaceComponents& components);

/// Returns the number of non-manifold edges: pairs of points that are corners of more than two triangles, however these
/// are glued.
std::size_t non_manifold_edges(std::span<const std::array<std::uint32_t, 3>> triangles);

/// Returns the numbers of the triangles, sorted by component: the component with the largest box first; of equal boxes,
/// the component that encloses more components. Triangles of one component, and components that are equal in both, keep
/// the order of the surface.
std::vector<std::uint32_t> by_shells(const SurfaceComponents& components);

}  // namespace rbpa::app

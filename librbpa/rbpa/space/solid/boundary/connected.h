// What: finds connected tetrahedra of a solid, and checks that a boundary belongs to a solid.
// Cost: linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/surface/levels/sub_surface.h"

namespace rbpa::space {

inline constexpr const char* not_its_boundary =
    "the boundary is not that of the solid, or the solid has no neighbors: expected solid_boundary(solid)";

/// Checks that `solid` has neighbors, and that `boundary` is closed and linked, has only corners below `points`, and
/// has one tetrahedron of `solid` for each triangle. Throws ContractViolation otherwise.
inline void require_boundary(std::size_t points, const Solid& solid, const SolidBoundary& boundary) {
  meshops::require(solid.neighbors.size() == solid.simplices.size() &&
                       boundary.tetrahedra.size() == boundary.surface.triangles.size(),
                   not_its_boundary);
  for (const std::uint32_t t : boundary.tetrahedra) meshops::require(t < solid.simplices.size(), not_its_boundary);
  require_linked(arrays_of(boundary.surface), points);
  for (const Triangle& neighbors : boundary.surface.neighbors)
    for (const std::uint32_t other : neighbors) meshops::require(other != Surface::none, not_its_boundary);
}

/// Returns the sets of tetrahedra connected through faces. Throws ContractViolation if a neighbor does not exist.
inline meshops::DisjointSets connected_through_faces(const Solid& solid) {
  meshops::DisjointSets sets(solid.simplices.size());
  for (std::uint32_t t = 0; t < solid.neighbors.size(); ++t)
    for (const std::uint32_t other : solid.neighbors[t]) {
      if (other < t) sets.join(t, other);
      meshops::require(other < sets.size() || other == Solid::none, not_its_boundary);
    }
  return sets;
}

/// Joins the sets of tetrahedra that meet in a point. Only points of the boundary are visited: around any other point,
/// all tetrahedra are connected through faces already.
/// Requires: `sets` is connected_through_faces(); `boundary` has passed require_boundary().
inline void connect_through_points(std::size_t points, const SolidBoundary& boundary, meshops::DisjointSets& sets) {
  std::vector<std::uint32_t> first(points, Solid::none);  // for each point of the boundary, a tetrahedron at the point
  for (std::size_t t = 0; t < boundary.tetrahedra.size(); ++t)
    for (const std::uint32_t corner : boundary.surface.triangles[t]) {
      if (first[corner] == Solid::none) first[corner] = boundary.tetrahedra[t];
      sets.join(first[corner], boundary.tetrahedra[t]);
    }
}

}  // namespace rbpa::space

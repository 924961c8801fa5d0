// What: makes a halfedge mesh of the triangles that fill() returned.
// Law:  an oriented 2-manifold with boundary, glued as the filling is. Vertex v stands on point v of the filling, and
//       face f is triangle f; unused points are isolated vertices. If several fans of triangles meet at a point,
//       because rings touch or groups overlap, the fans after the first have additional vertices, numbered after the
//       last point.
// Cost: linear.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/mesh.h"
#include "rbpa/fill/filling.h"

namespace rbpa {

struct FillingMesh {
  Mesh mesh;                                   ///< faces counter-clockwise; z = 0
  std::vector<std::uint32_t> point_of_vertex;  ///< for each vertex, the index of its point in the filling
};

/// Builds the halfedge mesh of a filling.
/// Requires: points, triangles and neighbors as fill() returns them.
/// Throws:   ContractViolation as require_linked().
RBPA_API FillingMesh filling_mesh(const Filling& filling);

}  // namespace rbpa

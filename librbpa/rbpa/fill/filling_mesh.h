// What: makes a halfedge mesh of the triangles that fill() returned.
// Law:  the mesh is an oriented 2-manifold with boundary, glued along the neighbors of the filling. Face f is triangle
//       f. Vertex v stands on point v of the filling; unused points are isolated vertices. If several fans of triangles
//       meet at a point, because rings touch or groups overlap, each fan but the first has an additional vertex there;
//       additional vertices are numbered after all points.
// Cost: linear.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/mesh.h"
#include "rbpa/fill/filling.h"

namespace rbpa {

/// Halfedge mesh of a filling.
struct FillingMesh {
  Mesh mesh;                                   ///< faces counter-clockwise; z = 0
  std::vector<std::uint32_t> point_of_vertex;  ///< for each vertex, the index of its point in the filling
};

/// Builds the halfedge mesh of a filling.
/// Requires: points, triangles and neighbors of a result of fill().
/// Throws:   ContractViolation as require_linked().
RBPA_API FillingMesh filling_mesh(const Filling& filling);

}  // namespace rbpa

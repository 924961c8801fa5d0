// What: a filling of polygons as a halfedge mesh.
// Law:  an oriented 2-manifold with boundary, glued as the filling is. Vertex v stands on point v as far as there are points, and
//       face f is triangle f; points that were not used are isolated vertices. Where rings touch or groups overlap, several
//       fans of triangles stand on a point: those after the first have the vertices behind the last point.
// Cost: linear.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/fill.h"
#include "rbpa/mesh.h"

namespace rbpa {

struct FillingMesh {
  Mesh mesh;                                   ///< z = 0
  std::vector<std::uint32_t> point_of_vertex;  ///< of the filling
};

/// Requires: points, triangles and neighbors as fill() returns them.
/// Throws:   ContractViolation as require_linked().
RBPA_API FillingMesh filling_mesh(const Filling& filling);

}  // namespace rbpa

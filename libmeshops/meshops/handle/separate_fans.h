// What: makes a manifold of a mesh in which fans touch at vertices, as OpenMesh's add_face() and its readers leave it.
// Law:  a mesh whose only defects are vertices with several fans has none afterwards; a sound mesh is not touched.
#pragma once

#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Gives each fan at a vertex a vertex of its own. The fan with the least halfedge keeps the old vertex; each further
/// fan gets a new vertex with copies of all properties, including the point.
/// Returns:  for each new vertex, in order, the vertex of which it is a copy.
/// Requires: the only defects that validate() finds are vertices with several fans; not checked.
/// Δ:        V +1 and χ +1 for each further fan. E and F stay.
/// Cost:     linear in the size of the mesh.
MESHOPS_API std::vector<Vertex> separate_fans(Connectivity& mesh);

}  // namespace meshops

// What: splits vertices at which several fans meet, as OpenMesh's add_face() and readers leave them, so that the mesh
//       is a manifold.
// Law:  a mesh whose only defects are vertices with several fans becomes sound; a sound mesh is not changed.
#pragma once

#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"

namespace meshops {

/// Gives each fan at a vertex its own vertex. The fan with the least halfedge keeps the old vertex; each further fan
/// gets a new vertex with copies of all properties of the old one, including the point.
/// Returns:  for each new vertex, in ascending order of handles, the old vertex of which it is a copy.
/// Requires: the only defects that validate() finds are vertices with several fans; not checked.
/// Δ:        V +1 and χ +1 for each further fan; E and F stay.
/// Cost:     linear in the size of the mesh.
MESHOPS_API std::vector<Vertex> separate_fans(Connectivity& mesh);

}  // namespace meshops

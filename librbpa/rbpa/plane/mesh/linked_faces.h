// What: the faces of a mesh as triangles in arrays, with their neighbors: without the detour over halfedges, each of which is a
//       cache miss.
#pragma once

#include "rbpa/base/triangle_arrays.h"
#include "rbpa/mesh.h"

namespace rbpa {

/// Corners are vertices; triangles are in the order of the faces.
OwnedTriangles linked_faces(const Mesh& mesh);

}  // namespace rbpa

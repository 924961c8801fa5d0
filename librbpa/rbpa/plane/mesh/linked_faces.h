// What: the faces of a mesh as triangles in arrays, with their neighbors. It avoids halfedges, each of which is a cache
//       miss.
#pragma once

#include "rbpa/base/mesh.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// Returns the faces as triangles, in their order; corners are vertices.
OwnedTriangles linked_faces(const Mesh& mesh);

}  // namespace rbpa

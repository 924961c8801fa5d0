// What: the faces of a mesh as triangles in arrays, with their neighbors. Code that reads the arrays avoids halfedges,
//       each of which is a cache miss.
#pragma once

#include "rbpa/base/mesh.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// Returns the faces as triangles, in the order of their numbers; corners are numbers of vertices.
OwnedTriangles linked_faces(const Mesh& mesh);

}  // namespace rbpa

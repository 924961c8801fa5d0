// What: the faces of a mesh as triangles in arrays, with their neighbours: without the detour over halfedges, each of which is a
//       cache miss.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/triangle_arrays.h"
#include "rbpa/mesh.h"

namespace rbpa {

struct LinkedFaces {
  std::vector<Triangle> triangles;  ///< vertices, in the order of the faces
  std::vector<Triangle> neighbors;  ///< neighbour k is the face across from corner k, or none
  operator TriangleArrays() const { return {triangles, neighbors}; }
};

LinkedFaces linked_faces(const Mesh& mesh);

}  // namespace rbpa

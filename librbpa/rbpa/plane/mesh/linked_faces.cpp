#include "rbpa/plane/mesh/linked_faces.h"

namespace rbpa {

OwnedTriangles linked_faces(const Mesh& mesh) {
  OwnedTriangles faces;
  faces.triangles.resize(mesh.n_faces());
  faces.neighbors.resize(mesh.n_faces());
  for (std::size_t f = 0; f < faces.triangles.size(); ++f) {
    auto h = mesh.halfedge_handle(Mesh::FaceHandle(static_cast<int>(f)));
    for (unsigned k = 0; k < 3; ++k) {
      // The side that ends at corner k lies across from corner k + 1.
      const auto beyond = mesh.face_handle(mesh.opposite_halfedge_handle(h));
      faces.triangles[f][k] = static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx());
      faces.neighbors[f][(k + 1) % 3] =
          beyond.is_valid() ? static_cast<std::uint32_t>(beyond.idx()) : TriangleArrays::none;
      h = mesh.next_halfedge_handle(h);
    }
  }
  return faces;
}

}  // namespace rbpa

// What: new elements of several kinds at once.
// Why:  OpenMesh goes through all properties of a kind for every single element, which is most of what a split costs.
#pragma once

#include <cstddef>

#include "meshops/core/connectivity.h"

namespace meshops::detail {

/// Adds elements and returns their handles, in ascending order of each kind.
class AddedElements {
 public:
  AddedElements(Connectivity& mesh, std::size_t vertices, std::size_t edges, std::size_t faces)
      : mesh_(mesh),
        vertex_(static_cast<int>(mesh.n_vertices())),
        edge_(static_cast<int>(mesh.n_edges())),
        face_(static_cast<int>(mesh.n_faces())) {
    mesh.resize(mesh.n_vertices() + vertices, mesh.n_edges() + edges, mesh.n_faces() + faces);
  }

  Vertex vertex() { return Vertex(vertex_++); }
  /// The halfedge from one vertex to the other, of the next edge.
  Halfedge edge(Vertex from, Vertex to) {
    const Halfedge h(2 * edge_++);
    mesh_.set_vertex_handle(h, to);
    mesh_.set_vertex_handle(mesh_.opposite_halfedge_handle(h), from);
    return h;
  }
  Face face() { return Face(face_++); }

 private:
  Connectivity& mesh_;
  int vertex_, edge_, face_;
};

}  // namespace meshops::detail

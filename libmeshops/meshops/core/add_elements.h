// What: adds vertices, edges and faces to a mesh in one step.
// Why:  for each single new element, OpenMesh visits all properties of its kind, which is most of the cost of a split.
#pragma once

#include <cstddef>

#include "meshops/core/connectivity.h"

namespace meshops::detail {

/// Elements that the constructor adds to a mesh together. vertex(), edge() and face() each return the next added handle
/// of their kind, in ascending order.
/// Requires: no member is called more often than elements of its kind were added; not checked.
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
  /// Returns the halfedge `from` → `to` of the next added edge.
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

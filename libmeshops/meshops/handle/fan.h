// What: how the handle operators merge and part the fans of faces around vertices.
// Law:  a fan of a boundary vertex is reached through its boundary halfedge, the one by which the boundary leaves it.
#pragma once

#include "meshops/core/connectivity.h"

namespace meshops::detail {

/// Makes every edge of the fan that `first` leaves start at `to` instead.
/// Cost: the degree.
inline void move_fan(Connectivity& mesh, Halfedge first, Vertex to) {
  Halfedge out = first;
  do {
    const Halfedge in = mesh.opposite_halfedge_handle(out);
    mesh.set_vertex_handle(in, to);
    out = mesh.next_halfedge_handle(in);
  } while (out != first);
}

/// Whether an edge joins two vertices, neither of them isolated.
/// Cost: the degree of `a`.
inline bool are_neighbours(const Connectivity& mesh, Vertex a, Vertex b) {
  const Halfedge first = mesh.halfedge_handle(a);
  Halfedge out = first;
  do {
    if (mesh.to_vertex_handle(out) == b) return true;
    out = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(out));
  } while (out != first);
  return false;
}

}  // namespace meshops::detail

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

}  // namespace meshops::detail

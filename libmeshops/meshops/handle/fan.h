// What: moves the fan of faces at a vertex to another vertex, as handle operators do to merge and to split vertices.
// Law:  callers name the fan of a boundary vertex by the boundary halfedge that leaves the vertex.
#pragma once

#include "meshops/core/connectivity.h"

namespace meshops::detail {

/// Makes `to` the start of the halfedges by which a fan leaves its vertex. `first` is one of these halfedges; at a
/// boundary vertex, `first` is the boundary halfedge. Changes nothing else: the caller sets the halfedges of vertices.
/// Cost: the number of edges of the fan.
inline void move_fan(Connectivity& mesh, Halfedge first, Vertex to) {
  Halfedge out = first;
  do {
    const Halfedge in = mesh.opposite_halfedge_handle(out);
    mesh.set_vertex_handle(in, to);
    out = mesh.next_halfedge_handle(in);
  } while (out != first);
}

}  // namespace meshops::detail

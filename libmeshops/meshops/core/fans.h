// What: tells whether the faces at a vertex form one fan, as everywhere on a manifold, or several. A fan is a sequence
//       of faces around a vertex, each adjacent to the next.
// Why:  OpenMesh links fans that meet in a vertex into one ring (a bowtie); its add_face() and its readers make such
//       rings. No operator of libmeshops does; operators that rely on one fan refuse vertices with several.
#pragma once

#include "meshops/core/connectivity.h"

namespace meshops {

namespace detail {

/// Returns whether the vertex that the boundary halfedge `out` leaves has several fans: the fan that begins with `out`
/// is not the fan that ends at prev(out). The walk advances from both ends at once, so that their cache misses overlap.
inline bool has_other_fans(const Connectivity& mesh, Halfedge out) {
  Halfedge first = out, last = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(out));
  while (first != last) {
    const Halfedge in = mesh.opposite_halfedge_handle(first);
    if (mesh.is_boundary(in)) return true;
    first = mesh.next_halfedge_handle(in);
    if (first == last) return false;
    if (mesh.is_boundary(last)) return true;
    last = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(last));
  }
  return false;
}

}  // namespace detail

/// Returns whether the vertex has several fans, that is, whether more than one boundary halfedge leaves the vertex;
/// false for an isolated vertex.
/// Requires: the vertex is live; its fans form one ring of links; the vertex's halfedge is a boundary halfedge if
///           any that leaves the vertex is. Not checked.
/// Cost:     linear in the degree of a boundary vertex; constant for a vertex that is inner or isolated.
inline bool has_several_fans(const Connectivity& mesh, Vertex v) {
  return !mesh.is_isolated(v) && mesh.is_boundary(v) && detail::has_other_fans(mesh, mesh.halfedge_handle(v));
}

}  // namespace meshops

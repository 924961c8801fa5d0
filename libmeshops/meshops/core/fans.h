// What: tells whether the faces at a vertex form one fan, as everywhere on a manifold, or several fans.
// How:  a fan is a sequence of faces around a vertex, each adjacent to the next.
// Why:  OpenMesh links several fans at a vertex into one ring (a bowtie), for example in add_face() and in its readers.
//       No operator of libmeshops makes such a ring; operators that rely on one fan refuse a vertex with several.
#pragma once

#include "meshops/core/connectivity.h"

namespace meshops {

namespace detail {

/// Returns whether the vertex that the boundary halfedge `out` leaves has several fans, that is, whether the fan that
/// begins with `out` is another fan than the one that ends with prev(out). The walk alternates between both fans, so
/// that their cache misses overlap.
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
/// Requires: the vertex is live; the links around it form one ring; its halfedge is a boundary halfedge if any boundary
///           halfedge leaves the vertex. Not checked.
/// Cost:     linear in the degree of a boundary vertex; constant for an inner or isolated vertex.
inline bool has_several_fans(const Connectivity& mesh, Vertex v) {
  return !mesh.is_isolated(v) && mesh.is_boundary(v) && detail::has_other_fans(mesh, mesh.halfedge_handle(v));
}

}  // namespace meshops

// What: whether the faces at a vertex are one fan, as everywhere on a manifold, or several.
// Why:  OpenMesh links fans that meet in a vertex in one ring (a bowtie), and add_face() and its readers make them. No
//       operator of libmeshops does; those that rely on one fan refuse the others.
#pragma once

#include "meshops/core/connectivity.h"

namespace meshops {

namespace detail {

inline constexpr const char* several_fans = "a vertex has several fans";

/// The boundary halfedge that comes in at the other end of the fan which the boundary halfedge `out` leaves.
inline Halfedge end_of_fan(const Connectivity& mesh, Halfedge out) {
  Halfedge in = mesh.opposite_halfedge_handle(out);
  do {
    in = mesh.opposite_halfedge_handle(mesh.next_halfedge_handle(in));
  } while (!mesh.is_boundary(in));
  return in;
}

/// The vertex that the boundary halfedge `out` leaves has other fans.
inline bool has_other_fans(const Connectivity& mesh, Halfedge out) {
  return mesh.next_halfedge_handle(end_of_fan(mesh, out)) != out;
}

}  // namespace detail

/// Several fans are linked in the ring of the vertex: more than one boundary halfedge leaves it.
/// Requires: the vertex is live.
/// Cost:     the degree; constant for a vertex that is inner or isolated.
inline bool has_several_fans(const Connectivity& mesh, Vertex v) {
  return !mesh.is_isolated(v) && mesh.is_boundary(v) && detail::has_other_fans(mesh, mesh.halfedge_handle(v));
}

}  // namespace meshops

// What:  the two changes of links behind all stellar operators except the flip: opening one vertex to two, and closing
//        two vertices to one.
// Law:   close_edge() of the halfedge that open_vertex() returns restores every live record. Only open_blocker() and
//        close_blocker() check the links.
#pragma once

#include <optional>

#include "meshops/core/blocker.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/live.h"
#include "meshops/stellar/count_effects.h"
#include "meshops/stellar/keep.h"

namespace meshops::detail {

/// Returns the next halfedge around the vertex that `h` leaves: ccw() counter-clockwise, cw() clockwise.
inline Halfedge ccw(const Connectivity& mesh, Halfedge h) {
  return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
}
inline Halfedge cw(const Connectivity& mesh, Halfedge h) {
  return mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
}

/// Returns whether a triangle lies on the left of the halfedge; false on the boundary.
inline bool is_triangle(const Connectivity& mesh, Halfedge h) {
  return !mesh.is_boundary(h) &&
         mesh.next_halfedge_handle(mesh.next_halfedge_handle(h)) == mesh.prev_halfedge_handle(h);
}

/// Links `a`, `b` and `c` to a loop, as the sides of `face`. `a` becomes the halfedge of the face.
inline void make_triangle(Connectivity& mesh, Face face, Halfedge a, Halfedge b, Halfedge c) {
  mesh.set_next_halfedge_handle(a, b);
  mesh.set_next_halfedge_handle(b, c);
  mesh.set_next_halfedge_handle(c, a);
  for (const Halfedge h : {a, b, c}) mesh.set_face_handle(h, face);
  mesh.set_halfedge_handle(face, a);
}

/// Puts `heir` in the place of h: between `before` and `after` in the loop of h, and into the record of the face of h
/// if the face refers to h.
inline void take_place(Connectivity& mesh, Halfedge heir, Halfedge h, Halfedge before, Halfedge after) {
  const Face face = mesh.face_handle(h);
  mesh.set_next_halfedge_handle(before, heir);
  mesh.set_next_halfedge_handle(heir, after);
  mesh.set_face_handle(heir, face);
  if (face.is_valid() && mesh.halfedge_handle(face) == h) mesh.set_halfedge_handle(face, heir);
}

/// Cuts the face of `from` and `to` along an edge between the starts of these two sides, which must not be neighbors.
/// `diagonal` is the halfedge of the new edge from the start of `from` to the start of `to`. The part without the
/// halfedge of the face goes to the face `added`. Returns: the halfedge of the new edge with `added` on its left.
Halfedge cut_face(Connectivity& mesh, Halfedge from, Halfedge to, Halfedge diagonal, Face added);

/// Makes `named` the halfedge of the vertex again, provided that `named` is live, leaves the vertex, and is a boundary
/// halfedge if the vertex is on the boundary.
inline void name_again(Connectivity& mesh, Vertex v, Halfedge named) {
  if (mesh.halfedge_handle(v) == named) return;
  if (is_live(mesh, named) && mesh.from_vertex_handle(named) == v && (mesh.is_boundary(named) || !mesh.is_boundary(v)))
    mesh.set_halfedge_handle(v, named);
}

/// Returns whether an edge joins a and b. Cost: a constant plus twice the lesser degree.
bool are_joined(const Connectivity& mesh, Vertex a, Vertex b);

/// Splits w: a new vertex takes over the edges of w from `left` to `right`, counter-clockwise and without these two,
/// and a triangle opens along each of the two. An invalid handle stands for the boundary; equal ones mean a full turn.
SplitEffect open_vertex(Connectivity& mesh, Vertex w, Halfedge left, Halfedge right);

/// Splits a vertex as open_vertex() does, but reuses the elements that a weld marked deleted: edges and faces in the
/// order of the effect. The mesh is sound afterwards, whatever these elements were before.
/// Requires: open_blocker() is empty; the effect has `left` or `right`; its elements are distinct and marked deleted.
void open_vertex_again(Connectivity& mesh, const WeldEffect& effect);

/// Returns why split_vertex(left, right, keep) is refused, or nothing when it is not refused.
std::optional<Blocker> open_blocker(const Connectivity& mesh, std::optional<Halfedge> left,
                                    std::optional<Halfedge> right, Keep keep);
/// Merges the start of h into its end, closes the faces at h, and marks the removed elements deleted.
WeldEffect close_edge(Connectivity& mesh, Halfedge h);
/// Merges as close_edge() does, but marks no element deleted.
WeldEffect close_links(Connectivity& mesh, Halfedge h);

/// Returns why close_edge(h) is refused, or nothing when it is not refused. Requires: h is live; not checked.
std::optional<Blocker> close_blocker(const Connectivity& mesh, Halfedge h, Keep keep);

}  // namespace meshops::detail

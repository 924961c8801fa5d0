// What:  the two changes of links that all stellar operators but the flip are: a vertex opens to two, two close to one.
// Law:   close_edge(open_vertex()) restores every live record. Nothing is checked here but by the two refusals.
#pragma once

#include <optional>
#include <string>

#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/stellar/effect.h"
#include "meshops/stellar/keep.h"

namespace meshops::detail {

inline Halfedge ccw(const Connectivity& mesh, Halfedge h) {
  return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
}
inline Halfedge cw(const Connectivity& mesh, Halfedge h) {
  return mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
}

/// The face left of the halfedge is a triangle; there may be none.
inline bool is_triangle(const Connectivity& mesh, Halfedge h) {
  return !mesh.is_boundary(h) &&
         mesh.next_halfedge_handle(mesh.next_halfedge_handle(h)) == mesh.prev_halfedge_handle(h);
}

/// Makes a face of three halfedges, and the first of them its halfedge.
inline void make_triangle(Connectivity& mesh, Face face, Halfedge a, Halfedge b, Halfedge c) {
  mesh.set_next_halfedge_handle(a, b);
  mesh.set_next_halfedge_handle(b, c);
  mesh.set_next_halfedge_handle(c, a);
  for (const Halfedge h : {a, b, c}) mesh.set_face_handle(h, face);
  mesh.set_halfedge_handle(face, a);
}

/// Cuts a face between the starts of two of its sides, which are no neighbors. `diagonal` runs from the first to the
/// second; the part without the halfedge of the face goes to `added`. Returns that halfedge of the diagonal which has
/// the new face on its left.
Halfedge cut_face(Connectivity& mesh, Halfedge from, Halfedge to, Halfedge diagonal, Face added);

[[noreturn]] void refuse(const char* operation, const char* refusal);

/// Throws ContractViolation "operation: reason", unless there is no reason.
inline void enforce(const char* operation, const char* refusal) {
  if (refusal) [[unlikely]]
    refuse(operation, refusal);
}

inline void require_status(const Connectivity& mesh, const char* operation) {
  enforce(operation, status_refusal(mesh));
}

inline std::optional<std::string> as_blocker(const char* refusal) {
  return refusal ? std::optional<std::string>(refusal) : std::nullopt;
}

/// The vertex names a halfedge again that it named once, if that is one it may name now.
inline void name_again(Connectivity& mesh, Vertex v, Halfedge named) {
  if (mesh.halfedge_handle(v) == named) return;
  if (is_live(mesh, named) && mesh.from_vertex_handle(named) == v && (mesh.is_boundary(named) || !mesh.is_boundary(v)))
    mesh.set_halfedge_handle(v, named);
}

/// An edge joins a and b. Cost: twice the lesser degree.
bool are_joined(const Connectivity& mesh, Vertex a, Vertex b);

/// The new vertex takes over the edges of w from `left` to `right`, counter-clockwise and without these two, and a
/// triangle opens along each of the two. An invalid handle stands for the boundary; equal ones for a full turn.
SplitEffect open_vertex(Connectivity& mesh, Vertex w, Halfedge left, Halfedge right);

/// The same with the elements of a weld that are marked deleted, which live again: edges and faces in the order in
/// which close_edge() names them. Whatever they were before, the mesh is sound.
/// Requires: open_refusal() is null; the effect names different elements, all of them deleted, and left or right.
void open_vertex_again(Connectivity& mesh, const WeldEffect& effect);

/// Why not, or nullptr: nothing to open, or halfedges that do not leave one live vertex; a gap of the boundary between
/// them at a vertex that has several; with Keep::simplicial the new vertex must not be joined to another twice.
const char* open_refusal(const Connectivity& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right,
                         Keep keep);
/// The vertex that h comes from goes into the one that it leads to; the faces of h close. What is removed is marked
/// deleted.
WeldEffect close_edge(Connectivity& mesh, Halfedge h);
/// The same without marks.
WeldEffect close_links(Connectivity& mesh, Halfedge h);

/// Why not, or nullptr. Requires a live halfedge.
const char* close_refusal(const Connectivity& mesh, Halfedge h, Keep keep);

}  // namespace meshops::detail

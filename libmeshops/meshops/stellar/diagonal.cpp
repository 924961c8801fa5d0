#include "meshops/stellar/diagonal.h"

#include "meshops/core/add_elements.h"
#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

const char* refusal(const Connectivity& mesh, Halfedge from, Halfedge to, Keep keep) {
  if (!is_live(mesh, from) || !is_live(mesh, to)) return "a halfedge does not exist or is deleted";
  if (mesh.is_boundary(from) || mesh.face_handle(from) != mesh.face_handle(to))
    return "the halfedges are not sides of one face";
  if (from == to || mesh.next_halfedge_handle(from) == to || mesh.next_halfedge_handle(to) == from)
    return "the corners are neighbors: a face of two sides would be left";
  const Vertex a = mesh.from_vertex_handle(from), b = mesh.from_vertex_handle(to);
  if (a == b) return "both corners are one vertex: the edge would be a loop";
  if (keep == Keep::manifold) return nullptr;
  if (detail::are_joined(mesh, a, b)) return "two edges would join the same vertices";
  const Halfedge second = mesh.next_halfedge_handle(from), fourth = mesh.next_halfedge_handle(to);
  const bool is_quadrangle = mesh.next_halfedge_handle(second) == to && mesh.next_halfedge_handle(fourth) == from;
  return is_quadrangle && mesh.from_vertex_handle(second) == mesh.from_vertex_handle(fourth)
             ? "two triangles would have the same corners"
             : nullptr;
}

const char* refusal(const Connectivity& mesh, Halfedge h) {
  if (const char* reason = detail::status_refusal(mesh)) return reason;
  if (!is_live(mesh, h)) return "the halfedge does not exist or is deleted";
  const Halfedge o = mesh.opposite_halfedge_handle(h);
  if (mesh.is_boundary(h) || mesh.is_boundary(o)) return "the edge is on the boundary";
  return mesh.face_handle(h) == mesh.face_handle(o) ? "the face lies on both sides of the edge" : nullptr;
}

}  // namespace

Halfedge detail::cut_face(Connectivity& mesh, Halfedge from, Halfedge to, Halfedge diagonal, Face added) {
  const Face face = mesh.face_handle(from);
  const Halfedge back = mesh.opposite_halfedge_handle(diagonal);
  const Halfedge before_from = mesh.prev_halfedge_handle(from), before_to = mesh.prev_halfedge_handle(to);
  // The diagonal closes the loop of the sides from `to` on; its opposite closes the loop of the sides from `from` on.
  mesh.set_next_halfedge_handle(before_from, diagonal);
  mesh.set_next_halfedge_handle(diagonal, to);
  mesh.set_next_halfedge_handle(before_to, back);
  mesh.set_next_halfedge_handle(back, from);
  mesh.set_face_handle(diagonal, face);
  mesh.set_face_handle(back, face);
  bool keeps_from = false;
  for (Halfedge h = from; h != back; h = mesh.next_halfedge_handle(h))
    keeps_from = keeps_from || h == mesh.halfedge_handle(face);
  const Halfedge side = keeps_from ? diagonal : back;
  Halfedge h = side;
  do {
    mesh.set_face_handle(h, added);
    h = mesh.next_halfedge_handle(h);
  } while (h != side);
  mesh.set_halfedge_handle(added, side);
  return side;
}

std::optional<std::string> insert_diagonal_blocker(const Connectivity& mesh, Halfedge from, Halfedge to, Keep keep) {
  return detail::as_blocker(refusal(mesh, from, to, keep));
}

InsertDiagonalEffect insert_diagonal(Connectivity& mesh, Halfedge from, Halfedge to, Keep keep) {
  detail::enforce("insert_diagonal", refusal(mesh, from, to, keep));
  detail::AddedElements elements(mesh, 0, 1, 1);
  const Halfedge diagonal = elements.edge(mesh.from_vertex_handle(from), mesh.from_vertex_handle(to));
  const Face face = elements.face();
  return {detail::cut_face(mesh, from, to, diagonal, face), face};
}

std::optional<std::string> remove_diagonal_blocker(const Connectivity& mesh, Halfedge h) {
  return detail::as_blocker(refusal(mesh, h));
}

RemoveDiagonalEffect remove_diagonal(Connectivity& mesh, Halfedge h) {
  detail::enforce("remove_diagonal", refusal(mesh, h));
  const Halfedge o = mesh.opposite_halfedge_handle(h);
  const Halfedge after_h = mesh.next_halfedge_handle(h), before_h = mesh.prev_halfedge_handle(h);
  const Halfedge after_o = mesh.next_halfedge_handle(o), before_o = mesh.prev_halfedge_handle(o);
  const Vertex a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
  const RemoveDiagonalEffect effect{mesh.edge_handle(h), mesh.face_handle(h), mesh.face_handle(o), after_o, after_h};
  for (Halfedge side = after_h; side != h; side = mesh.next_halfedge_handle(side))
    mesh.set_face_handle(side, effect.survivor);
  mesh.set_next_halfedge_handle(before_o, after_h);
  mesh.set_next_halfedge_handle(before_h, after_o);
  if (mesh.halfedge_handle(effect.survivor) == o) mesh.set_halfedge_handle(effect.survivor, after_o);
  if (mesh.halfedge_handle(a) == h) mesh.set_halfedge_handle(a, after_o);
  if (mesh.halfedge_handle(b) == o) mesh.set_halfedge_handle(b, after_h);
  mesh.status(effect.face).set_deleted(true);
  mesh.status(effect.edge).set_deleted(true);
  for (const Halfedge side : {h, o}) mesh.status(side).set_deleted(true);
  return effect;
}

}  // namespace meshops

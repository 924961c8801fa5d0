#include "meshops/stellar/diagonal.h"

#include "meshops/core/add_elements.h"
#include "meshops/stellar/relink.h"

namespace meshops {

Halfedge detail::cut_face(Connectivity& mesh, Halfedge from, Halfedge to, Halfedge diagonal, Face added) {
  const Face face = mesh.face_handle(from);
  const Halfedge back = mesh.opposite_halfedge_handle(diagonal);
  const Halfedge before_from = mesh.prev_halfedge_handle(from), before_to = mesh.prev_halfedge_handle(to);
  // The diagonal closes the loop that begins with `to`; its opposite closes the loop that begins with `from`.
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

std::optional<Blocker> insert_diagonal_blocker(const Connectivity& mesh, Halfedge from, Halfedge to, Keep keep) {
  for (const Halfedge h : {from, to})
    if (!is_live(mesh, h)) return Blocker(BlockerKind::missing, h);
  const Face face = mesh.face_handle(from);
  if (mesh.is_boundary(from) || face != mesh.face_handle(to)) return Blocker(BlockerKind::other_face, to);
  if (from == to) return Blocker(BlockerKind::same_edge, mesh.edge_handle(to));
  if (mesh.next_halfedge_handle(from) == to || mesh.next_halfedge_handle(to) == from)
    return Blocker(BlockerKind::corners_adjacent, to);
  const Vertex a = mesh.from_vertex_handle(from), b = mesh.from_vertex_handle(to);
  if (a == b) return Blocker(BlockerKind::corner_repeated, a);
  if (keep == Keep::manifold) return std::nullopt;
  if (detail::are_joined(mesh, a, b)) return Blocker(BlockerKind::double_edge, a);
  const Halfedge second = mesh.next_halfedge_handle(from), fourth = mesh.next_halfedge_handle(to);
  const bool is_quadrangle = mesh.next_halfedge_handle(second) == to && mesh.next_halfedge_handle(fourth) == from;
  if (is_quadrangle && mesh.from_vertex_handle(second) == mesh.from_vertex_handle(fourth))
    return Blocker(BlockerKind::equal_halves, face);
  return std::nullopt;
}

InsertDiagonalEffect insert_diagonal(Connectivity& mesh, Halfedge from, Halfedge to, Keep keep) {
  detail::enforce("insert_diagonal", insert_diagonal_blocker(mesh, from, to, keep));
  detail::AddedElements elements(mesh, 0, 1, 1);
  const Halfedge diagonal = elements.edge(mesh.from_vertex_handle(from), mesh.from_vertex_handle(to));
  const Face face = elements.face();
  return {detail::cut_face(mesh, from, to, diagonal, face), face};
}

std::optional<Blocker> remove_diagonal_blocker(const Connectivity& mesh, Halfedge h) {
  if (const auto reason = detail::status_blocker(mesh)) return reason;
  if (!is_live(mesh, h)) return Blocker(BlockerKind::missing, h);
  const Halfedge o = mesh.opposite_halfedge_handle(h);
  if (mesh.is_boundary(h) || mesh.is_boundary(o)) return Blocker(BlockerKind::on_boundary, mesh.edge_handle(h));
  const Face face = mesh.face_handle(h);
  return face == mesh.face_handle(o) ? std::optional(Blocker(BlockerKind::face_on_both_sides, face)) : std::nullopt;
}

RemoveDiagonalEffect remove_diagonal(Connectivity& mesh, Halfedge h) {
  detail::enforce("remove_diagonal", remove_diagonal_blocker(mesh, h));
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

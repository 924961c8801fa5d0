#include "meshops/stellar/split_edge.h"

#include "meshops/core/add_elements.h"
#include "meshops/stellar/relink.h"

namespace meshops {

std::optional<Blocker> split_edge_blocker(const Connectivity& mesh, Halfedge h, Keep keep) {
  if (!is_live(mesh, h)) return Blocker(BlockerKind::missing, h);
  const Halfedge o = mesh.opposite_halfedge_handle(h);
  for (const Halfedge side : {h, o})
    if (!mesh.is_boundary(side) && !detail::is_triangle(mesh, side))
      return Blocker(BlockerKind::not_triangle, mesh.face_handle(side));
  if (keep == Keep::manifold || mesh.is_boundary(h) || mesh.is_boundary(o)) return std::nullopt;
  const auto apex = [&](Halfedge side) { return mesh.to_vertex_handle(mesh.next_halfedge_handle(side)); };
  return apex(h) == apex(o) ? std::optional(Blocker(BlockerKind::double_edge, apex(h))) : std::nullopt;
}

std::optional<Blocker> split_edge_blocker(const Connectivity& mesh, Edge e, Keep keep) {
  return is_live(mesh, e) ? split_edge_blocker(mesh, mesh.halfedge_handle(e, 0), keep)
                          : Blocker(BlockerKind::missing, e);
}

SplitEdgeEffect split_edge(Connectivity& mesh, Halfedge h, Keep keep) {
  detail::enforce("split_edge", split_edge_blocker(mesh, h, keep));
  // Does what detail::open_vertex() does at b, without its case distinctions, as the only edge that moves is known.
  const Halfedge o = mesh.opposite_halfedge_handle(h);
  const Halfedge after_h = mesh.next_halfedge_handle(h), before_o = mesh.prev_halfedge_handle(o);
  const bool has_left = !mesh.is_boundary(h), has_right = !mesh.is_boundary(o);
  const Vertex b = mesh.to_vertex_handle(h);
  SplitEdgeEffect effect;
  effect.line = h;
  StarElements& added = effect.added;
  added.at_boundary = !has_left || !has_right;
  detail::AddedElements elements(mesh, 1, added.edges().size(), added.faces().size());
  const Vertex v = added.vertex = elements.vertex();
  const Halfedge vb = effect.halfedge = elements.edge(v, b), bv = mesh.opposite_halfedge_handle(vb);
  added.edge[0] = mesh.edge_handle(vb);
  mesh.set_vertex_handle(h, v);
  if (has_left) {
    const Halfedge vc = elements.edge(v, mesh.to_vertex_handle(after_h));
    added.edge[1] = mesh.edge_handle(vc);
    added.face[0] = elements.face();
    detail::take_place(mesh, vc, after_h, h, mesh.next_halfedge_handle(after_h));
    detail::make_triangle(mesh, added.face[0], vb, after_h, mesh.opposite_halfedge_handle(vc));
  } else {
    mesh.set_next_halfedge_handle(h, vb);
    mesh.set_next_halfedge_handle(vb, after_h);
  }
  if (has_right) {
    const Halfedge vd = elements.edge(v, mesh.from_vertex_handle(before_o));
    added.edge[has_left ? 2 : 1] = mesh.edge_handle(vd);
    const Face face = added.face[has_left ? 1 : 0] = elements.face();
    detail::take_place(mesh, mesh.opposite_halfedge_handle(vd), before_o, mesh.prev_halfedge_handle(before_o), o);
    detail::make_triangle(mesh, face, bv, vd, before_o);
  } else {
    mesh.set_next_halfedge_handle(before_o, bv);
    mesh.set_next_halfedge_handle(bv, o);
  }
  const bool b_named_o = mesh.halfedge_handle(b) == o;
  mesh.set_halfedge_handle(v,
                           b_named_o || !has_right ? o : vb);  // b may refer to another halfedge if it has several fans
  if (b_named_o) mesh.set_halfedge_handle(b, bv);
  return effect;
}

SplitEdgeEffect split_edge(Connectivity& mesh, Edge e, Keep keep) {
  if (!is_live(mesh, e)) detail::enforce("split_edge", std::optional(Blocker(BlockerKind::missing, e)));
  return split_edge(mesh, mesh.halfedge_handle(e, 0), keep);
}

}  // namespace meshops

#include "meshops/stellar/flip.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

/// The six halfedges of two triangles with a common edge: h = a→b with the apex c, o = b→a with the apex d.
struct Quadrangle {
  Quadrangle(const Connectivity& mesh, Edge e)
      : h(mesh.halfedge_handle(e, 0)),
        bc(mesh.next_halfedge_handle(h)),
        ca(mesh.prev_halfedge_handle(h)),
        o(mesh.opposite_halfedge_handle(h)),
        ad(mesh.next_halfedge_handle(o)),
        db(mesh.prev_halfedge_handle(o)) {}
  Halfedge h, bc, ca, o, ad, db;
};

/// Returns whether an edge joins the apexes. Walks around the first apex, from one side of its triangle to the other:
/// the records beside the quadrangle are read anyway, and most vertices have few edges.
bool apexes_are_joined(const Connectivity& mesh, const Quadrangle& q, Vertex c, Vertex d) {
  constexpr int usual_degree = 12;
  const Halfedge end = mesh.opposite_halfedge_handle(q.bc);
  int looked = 0;
  for (Halfedge out = detail::cw(mesh, q.ca); out != end; out = detail::cw(mesh, out)) {
    if (mesh.to_vertex_handle(out) == d) return true;
    if (++looked == usual_degree) return detail::are_joined(mesh, c, d);
  }
  return false;
}

/// Links `h`, `after` and `before` to a loop in this order, as sides of the face of `h`.
void link(Connectivity& mesh, Halfedge h, Halfedge after, Halfedge before) {
  const Face face = mesh.face_handle(h);
  mesh.set_next_halfedge_handle(h, after);
  mesh.set_next_halfedge_handle(after, before);
  mesh.set_next_halfedge_handle(before, h);
  mesh.set_face_handle(after, face);
  mesh.set_face_handle(before, face);
}

}  // namespace

std::optional<Blocker> flip_blocker(const Connectivity& mesh, Edge e, Keep keep) {
  if (!is_live(mesh, e)) return Blocker(BlockerKind::missing, e);
  const Quadrangle q(mesh, e);
  if (mesh.is_boundary(q.h) || mesh.is_boundary(q.o)) return Blocker(BlockerKind::on_boundary, e);
  for (const Halfedge side : {q.h, q.o})
    if (!detail::is_triangle(mesh, side)) return Blocker(BlockerKind::not_triangle, mesh.face_handle(side));
  const Vertex c = mesh.to_vertex_handle(q.bc), d = mesh.to_vertex_handle(q.ad);
  if (c == d) return Blocker(BlockerKind::loop_edge, e);
  if (keep == Keep::simplicial && apexes_are_joined(mesh, q, c, d)) return Blocker(BlockerKind::double_edge, c);
  return std::nullopt;
}

FlipEffect flip(Connectivity& mesh, Edge e, Keep keep) {
  detail::enforce("flip", flip_blocker(mesh, e, keep));
  const Quadrangle q(mesh, e);
  const Face left = mesh.face_handle(q.h), right = mesh.face_handle(q.o);
  const Vertex a = mesh.to_vertex_handle(q.o), b = mesh.to_vertex_handle(q.h);
  const FlipEffect effect{e, {mesh.halfedge_handle(a), mesh.halfedge_handle(b)}};
  if (effect.named[0] == q.h) mesh.set_halfedge_handle(a, q.ad);
  if (effect.named[1] == q.o) mesh.set_halfedge_handle(b, q.bc);
  if (mesh.halfedge_handle(left) == q.bc) mesh.set_halfedge_handle(left, q.ad);
  if (mesh.halfedge_handle(right) == q.ad) mesh.set_halfedge_handle(right, q.bc);
  mesh.set_vertex_handle(q.h, mesh.to_vertex_handle(q.bc));
  mesh.set_vertex_handle(q.o, mesh.to_vertex_handle(q.ad));
  link(mesh, q.h, q.ca, q.ad);
  link(mesh, q.o, q.db, q.bc);
  return effect;
}

void undo(Connectivity& mesh, const FlipEffect& effect) {
  detail::enforce("undo", flip_blocker(mesh, effect.edge, Keep::manifold));
  // Before the undo, h = d→c, with ca and ad on the left, db and bc on the right.
  const Halfedge h = mesh.halfedge_handle(effect.edge, 0), o = mesh.opposite_halfedge_handle(h);
  const Halfedge ca = mesh.next_halfedge_handle(h), ad = mesh.prev_halfedge_handle(h);
  const Halfedge db = mesh.next_halfedge_handle(o), bc = mesh.prev_halfedge_handle(o);
  const Face left = mesh.face_handle(h), right = mesh.face_handle(o);
  const Vertex a = mesh.to_vertex_handle(ca), b = mesh.to_vertex_handle(db);
  const Vertex c = mesh.to_vertex_handle(h), d = mesh.to_vertex_handle(o);
  // flip() does not make o and h the halfedges of c and d, but later operators may have done so.
  if (mesh.halfedge_handle(c) == o) mesh.set_halfedge_handle(c, ca);
  if (mesh.halfedge_handle(d) == h) mesh.set_halfedge_handle(d, db);
  if (mesh.halfedge_handle(left) == ad) mesh.set_halfedge_handle(left, bc);
  if (mesh.halfedge_handle(right) == bc) mesh.set_halfedge_handle(right, ad);
  mesh.set_vertex_handle(h, b);
  mesh.set_vertex_handle(o, a);
  link(mesh, h, bc, ca);
  link(mesh, o, ad, db);
  detail::name_again(mesh, a, effect.named[0]);
  detail::name_again(mesh, b, effect.named[1]);
}

}  // namespace meshops

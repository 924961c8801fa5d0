#include "meshops/stellar/flip.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

/// The six halfedges of two triangles with a common edge: h = a→b with apex c, o = b→a with apex d.
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

const char* refusal(const Connectivity& mesh, Edge e) { return is_live(mesh, e) ? nullptr : "no such edge"; }

const char* refusal(const Connectivity& mesh, const Quadrangle& q, Keep keep) {
  if (mesh.is_boundary(q.h) || mesh.is_boundary(q.o)) return "the edge is on the boundary";
  if (!detail::is_triangle(mesh, q.h) || !detail::is_triangle(mesh, q.o)) return "a face is not a triangle";
  const Vertex c = mesh.to_vertex_handle(q.bc), d = mesh.to_vertex_handle(q.ad);
  if (c == d) return "both triangles have the same apex: the edge would become a loop";
  if (keep == Keep::simplicial && detail::are_joined(mesh, c, d)) return "two edges would join the same vertices";
  return nullptr;
}

/// Puts h, whose ends are set, into a triangle of its face with the sides that follow it, one of which comes from the
/// other face.
void link(Connectivity& mesh, Halfedge h, Halfedge after, Halfedge before, Halfedge comes) {
  mesh.set_next_halfedge_handle(h, after);
  mesh.set_next_halfedge_handle(after, before);
  mesh.set_next_halfedge_handle(before, h);
  mesh.set_face_handle(comes, mesh.face_handle(h));
}

}  // namespace

std::optional<std::string> flip_blocker(const Connectivity& mesh, Edge e, Keep keep) {
  const char* reason = refusal(mesh, e);
  return detail::as_blocker(reason ? reason : refusal(mesh, Quadrangle(mesh, e), keep));
}

FlipEffect flip(Connectivity& mesh, Edge e, Keep keep) {
  detail::enforce("flip", refusal(mesh, e));
  const Quadrangle q(mesh, e);
  detail::enforce("flip", refusal(mesh, q, keep));
  const Face left = mesh.face_handle(q.h), right = mesh.face_handle(q.o);
  const Vertex a = mesh.to_vertex_handle(q.o), b = mesh.to_vertex_handle(q.h);
  const FlipEffect effect{e, {mesh.halfedge_handle(a), mesh.halfedge_handle(b)}};
  if (effect.named[0] == q.h) mesh.set_halfedge_handle(a, q.ad);
  if (effect.named[1] == q.o) mesh.set_halfedge_handle(b, q.bc);
  if (mesh.halfedge_handle(left) == q.bc) mesh.set_halfedge_handle(left, q.ad);
  if (mesh.halfedge_handle(right) == q.ad) mesh.set_halfedge_handle(right, q.bc);
  mesh.set_vertex_handle(q.h, mesh.to_vertex_handle(q.bc));
  mesh.set_vertex_handle(q.o, mesh.to_vertex_handle(q.ad));
  link(mesh, q.h, q.ca, q.ad, q.ad);
  link(mesh, q.o, q.db, q.bc, q.bc);
  return effect;
}

void undo(Connectivity& mesh, const FlipEffect& effect) {
  // Now h = d→c with ca, ad on the left and db, bc on the right.
  const Halfedge h = mesh.halfedge_handle(effect.edge, 0), o = mesh.opposite_halfedge_handle(h);
  const Halfedge ca = mesh.next_halfedge_handle(h), ad = mesh.prev_halfedge_handle(h);
  const Halfedge db = mesh.next_halfedge_handle(o), bc = mesh.prev_halfedge_handle(o);
  const Face left = mesh.face_handle(h), right = mesh.face_handle(o);
  const Vertex a = mesh.to_vertex_handle(ca), b = mesh.to_vertex_handle(db);
  if (mesh.halfedge_handle(left) == ad) mesh.set_halfedge_handle(left, bc);
  if (mesh.halfedge_handle(right) == bc) mesh.set_halfedge_handle(right, ad);
  mesh.set_vertex_handle(h, b);
  mesh.set_vertex_handle(o, a);
  link(mesh, h, bc, ca, bc);
  link(mesh, o, ad, db, ad);
  mesh.set_halfedge_handle(a, effect.named[0]);
  mesh.set_halfedge_handle(b, effect.named[1]);
}

}  // namespace meshops

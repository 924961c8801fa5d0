#include "meshops/stellar/undo.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

template <typename Element>
bool is_marked(const Connectivity& mesh, std::size_t count, Element element) {
  return element.idx() >= 0 && static_cast<std::size_t>(element.idx()) < count && mesh.status(element).deleted();
}

/// What took the place of h in the record of the face gives it back.
void give_back(Connectivity& mesh, Halfedge heir, Halfedge h) {
  if (const Face f = mesh.face_handle(h); f.is_valid() && mesh.halfedge_handle(f) == heir)
    mesh.set_halfedge_handle(f, h);
}

}  // namespace

void undo(Connectivity& mesh, const WeldEffect& effect) {
  detail::require_status(mesh);
  const StarElements& removed = effect.removed;
  bool marked = is_marked(mesh, mesh.n_vertices(), removed.vertex);
  for (const Edge e : removed.edges()) marked = marked && is_marked(mesh, mesh.n_edges(), e);
  for (const Face f : removed.faces()) marked = marked && is_marked(mesh, mesh.n_faces(), f);
  require(marked, "undo: the elements are not there to be brought back");

  mesh.status(removed.vertex).set_deleted(false);
  for (const Face f : removed.faces()) mesh.status(f).set_deleted(false);
  // The records of what was removed are as they were: they say where it belongs.
  for (const Edge e : removed.edges()) {
    mesh.status(e).set_deleted(false);
    for (const unsigned side : {0u, 1u}) {
      const Halfedge h = mesh.halfedge_handle(e, side);
      mesh.status(h).set_deleted(false);
      mesh.set_next_halfedge_handle(mesh.prev_halfedge_handle(h), h);
      mesh.set_next_halfedge_handle(h, mesh.next_halfedge_handle(h));
    }
  }
  const Vertex v = removed.vertex;
  const Halfedge first = mesh.halfedge_handle(v);
  Halfedge out = first;
  do {
    mesh.set_vertex_handle(mesh.opposite_halfedge_handle(out), v);
    out = detail::ccw(mesh, out);
  } while (out != first);

  const Halfedge h = effect.halfedge, o = mesh.opposite_halfedge_handle(h);
  const Halfedge wc = mesh.next_halfedge_handle(h), cv = mesh.prev_halfedge_handle(h);
  const Halfedge dw = mesh.prev_halfedge_handle(o), vd = mesh.next_halfedge_handle(o);
  const Halfedge vc = mesh.opposite_halfedge_handle(cv);
  const bool v_has_degree_two = effect.left && effect.right && vc == vd;  // then only the edge of dw stayed
  if (effect.left) {
    mesh.set_face_handle(wc, mesh.face_handle(h));
    mesh.set_halfedge_handle(mesh.to_vertex_handle(wc), effect.named[1]);
    if (!v_has_degree_two) give_back(mesh, wc, vc);
  }
  if (effect.right) {
    mesh.set_face_handle(dw, mesh.face_handle(o));
    mesh.set_halfedge_handle(mesh.from_vertex_handle(dw), effect.named[2]);
    give_back(mesh, dw, mesh.opposite_halfedge_handle(v_has_degree_two ? wc : vd));
  }
  mesh.set_halfedge_handle(effect.survivor, effect.named[0]);
}

}  // namespace meshops

#include "meshops/stellar/split_face.h"

#include "meshops/core/add_elements.h"
#include "meshops/stellar/relink.h"

namespace meshops {
std::optional<Blocker> split_face_blocker(const Connectivity& mesh, Face f) {
  if (!is_live(mesh, f)) return Blocker(BlockerKind::missing, f);
  if (!detail::is_triangle(mesh, mesh.halfedge_handle(f))) return Blocker(BlockerKind::not_triangle, f);
  return std::nullopt;
}

SplitFaceEffect split_face(Connectivity& mesh, Face f) {
  detail::enforce("split_face", split_face_blocker(mesh, f));
  // Does what detail::open_vertex() does at the corner w, without its case distinctions, because no edge moves and no
  // new edge is on the boundary.
  const Halfedge wc = mesh.halfedge_handle(f), cd = mesh.next_halfedge_handle(wc), dw = mesh.next_halfedge_handle(cd);
  SplitFaceEffect effect;
  effect.face = f;
  detail::AddedElements elements(mesh, 1, 3, 2);
  const Vertex v = effect.added.vertex = elements.vertex();
  const Halfedge vw = effect.halfedge = elements.edge(v, mesh.to_vertex_handle(dw));
  const Halfedge vc = elements.edge(v, mesh.to_vertex_handle(wc)), vd = elements.edge(v, mesh.to_vertex_handle(cd));
  effect.added.edge = {mesh.edge_handle(vw), mesh.edge_handle(vc), mesh.edge_handle(vd)};
  for (Face& face : effect.added.face) face = elements.face();
  detail::make_triangle(mesh, f, vc, cd, mesh.opposite_halfedge_handle(vd));
  detail::make_triangle(mesh, effect.added.face[0], vw, wc, mesh.opposite_halfedge_handle(vc));
  detail::make_triangle(mesh, effect.added.face[1], mesh.opposite_halfedge_handle(vw), vd, dw);
  mesh.set_halfedge_handle(v, vw);
  return effect;
}

}  // namespace meshops

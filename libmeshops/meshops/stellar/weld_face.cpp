#include "meshops/stellar/weld_face.h"

#include "meshops/stellar/relink.h"

namespace meshops {
std::optional<Blocker> weld_face_blocker(const Connectivity& mesh, Vertex v, Keep keep) {
  if (const auto reason = detail::status_blocker(mesh)) return reason;
  if (!is_live(mesh, v)) return Blocker(BlockerKind::missing, v);
  if (mesh.is_isolated(v)) return Blocker(BlockerKind::isolated, v);
  if (mesh.is_boundary(v)) return Blocker(BlockerKind::on_boundary, v);
  const Halfedge first = mesh.halfedge_handle(v), second = detail::ccw(mesh, first), third = detail::ccw(mesh, second);
  if (first == third || detail::ccw(mesh, third) != first) return Blocker(BlockerKind::wrong_degree, v, 3);
  if (!detail::is_triangle(mesh, second)) return Blocker(BlockerKind::not_triangle, mesh.face_handle(second));
  return detail::close_blocker(mesh, first, keep);
}

WeldFaceEffect weld_face(Connectivity& mesh, Vertex v, Keep keep) {
  detail::enforce("weld_face", weld_face_blocker(mesh, v, keep));
  const Halfedge first = mesh.halfedge_handle(v);
  const Face face = mesh.face_handle(detail::ccw(mesh, first));
  return {detail::close_edge(mesh, first), face};
}

}  // namespace meshops

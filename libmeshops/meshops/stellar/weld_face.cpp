#include "meshops/stellar/weld_face.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

const char* refusal(const Connectivity& mesh, Vertex v, Keep keep) {
  if (const char* reason = detail::status_refusal(mesh)) return reason;
  if (!is_live(mesh, v)) return "the vertex does not exist or is deleted";
  if (mesh.is_isolated(v)) return "the vertex is isolated";
  if (mesh.is_boundary(v)) return "the vertex is on the boundary";
  const Halfedge first = mesh.halfedge_handle(v), second = detail::ccw(mesh, first), third = detail::ccw(mesh, second);
  if (first == third || detail::ccw(mesh, third) != first) return "the vertex does not have three edges";
  if (!detail::is_triangle(mesh, second)) return "a face is not a triangle";
  return detail::close_refusal(mesh, first, keep);
}

}  // namespace

std::optional<std::string> weld_face_blocker(const Connectivity& mesh, Vertex v, Keep keep) {
  return detail::as_blocker(refusal(mesh, v, keep));
}

WeldFaceEffect weld_face(Connectivity& mesh, Vertex v, Keep keep) {
  detail::enforce("weld_face", refusal(mesh, v, keep));
  const Halfedge first = mesh.halfedge_handle(v);
  const Face face = mesh.face_handle(detail::ccw(mesh, first));
  return {detail::close_edge(mesh, first), face};
}

}  // namespace meshops

#include "meshops/stellar/split_face.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

const char* refusal(const Connectivity& mesh, Face f) {
  if (!is_live(mesh, f)) return "no such face";
  return detail::is_triangle(mesh, mesh.halfedge_handle(f)) ? nullptr : "the face is not a triangle";
}

}  // namespace

std::optional<std::string> split_face_blocker(const Connectivity& mesh, Face f) {
  return detail::as_blocker(refusal(mesh, f));
}

SplitEffect split_face(Connectivity& mesh, Face f) {
  detail::enforce("split_face", refusal(mesh, f));
  const Halfedge out = mesh.halfedge_handle(f);
  return detail::open_vertex(mesh, mesh.from_vertex_handle(out), out, detail::ccw(mesh, out));
}

}  // namespace meshops

#include "meshops/handle/close_curve.h"

#include "meshops/core/contract.h"
#include "meshops/core/fans.h"
#include "meshops/core/live.h"
#include "meshops/handle/unchecked.h"

namespace meshops {
namespace {

const char* reason_against_closing(const Connectivity& mesh, Halfedge h) {
  if (!is_live(mesh, h)) return "the halfedge does not exist or is deleted";
  if (!mesh.is_boundary(h)) return "the halfedge is not on the boundary";
  if (mesh.next_halfedge_handle(mesh.next_halfedge_handle(h)) == h) return "the curve has two edges: glue them";
  Halfedge side = h;
  do {
    if (detail::has_other_fans(mesh, side)) return detail::several_fans;
    side = mesh.next_halfedge_handle(side);
  } while (side != h);
  return nullptr;
}

/// Returns whether another side of the face of `h` starts at the same vertex as `h`.
bool is_passed_again(const Connectivity& mesh, Halfedge h) {
  const Face f = mesh.face_handle(h);
  for (Halfedge out = h;;) {
    out = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(out));
    if (out == h) return false;
    if (mesh.face_handle(out) == f) return true;
  }
}

const char* reason_against_opening(const Connectivity& mesh, Face f) {
  if (!mesh.has_face_status()) return "the mesh needs face status to mark what is deleted (request_face_status())";
  if (!is_live(mesh, f)) return "the face does not exist or is deleted";
  const Halfedge first = mesh.halfedge_handle(f);
  Halfedge h = first;
  std::size_t sides = 0;
  do {
    if (mesh.is_boundary(mesh.opposite_halfedge_handle(h))) return "a side of the face is on the boundary";
    if (mesh.is_boundary(mesh.from_vertex_handle(h))) return "a corner of the face is on the boundary";
    if (mesh.face_handle(mesh.opposite_halfedge_handle(h)) == f) return "the face lies on both sides of an edge";
    ++sides;
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  if (sides == 3) return nullptr;  // its corners are three distinct vertices, because no edge is a loop
  do {
    if (is_passed_again(mesh, h)) return "the face passes a vertex twice";
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  return nullptr;
}

}  // namespace

std::optional<std::string> close_curve_blocker(const Connectivity& mesh, Halfedge h) {
  return detail::as_blocker(reason_against_closing(mesh, h));
}

CloseCurveEffect close_curve(Connectivity& mesh, Halfedge h) {
  detail::enforce("close_curve", reason_against_closing(mesh, h));
  const Face f = mesh.new_face();
  mesh.set_halfedge_handle(f, h);
  Halfedge side = h;
  do {
    mesh.set_face_handle(side, f);
    side = mesh.next_halfedge_handle(side);
  } while (side != h);
  return {f};
}

std::optional<std::string> open_curve_blocker(const Connectivity& mesh, Face f) {
  return detail::as_blocker(reason_against_opening(mesh, f));
}

OpenCurveEffect open_curve(Connectivity& mesh, Face f) {
  detail::enforce("open_curve", reason_against_opening(mesh, f));
  const Halfedge first = mesh.halfedge_handle(f);
  Halfedge h = first;
  do {
    mesh.set_boundary(h);
    mesh.set_halfedge_handle(mesh.from_vertex_handle(h), h);
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  mesh.status(f).set_deleted(true);
  return {first};
}

}  // namespace meshops

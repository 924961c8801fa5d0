#include "meshops/handle/close_curve.h"

#include "meshops/core/contract.h"
#include "meshops/core/live.h"

namespace meshops {
namespace {

const char* reason_against_closing(const Connectivity& mesh, Halfedge h) {
  if (!is_live(mesh, h)) return "no such halfedge";
  if (!mesh.is_boundary(h)) return "the halfedge is not on the boundary";
  if (mesh.next_halfedge_handle(mesh.next_halfedge_handle(h)) == h) return "the curve has two edges: glue them";
  return nullptr;
}

const char* reason_against_opening(const Connectivity& mesh, Face f) {
  if (!is_live(mesh, f)) return "no such face";
  const Halfedge first = mesh.halfedge_handle(f);
  Halfedge h = first;
  do {
    if (mesh.is_boundary(mesh.opposite_halfedge_handle(h))) return "a side of the face is on the boundary";
    if (mesh.is_boundary(mesh.from_vertex_handle(h))) return "a corner of the face is on the boundary";
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  return nullptr;
}

}  // namespace

std::optional<std::string> close_curve_blocker(const Connectivity& mesh, Halfedge h) {
  if (const char* reason = reason_against_closing(mesh, h)) return reason;
  return std::nullopt;
}

CloseCurveEffect close_curve(Connectivity& mesh, Halfedge h) {
  if (const char* reason = reason_against_closing(mesh, h))
    throw ContractViolation(std::string("close_curve: ") + reason);
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
  if (const char* reason = reason_against_opening(mesh, f)) return reason;
  return std::nullopt;
}

OpenCurveEffect open_curve(Connectivity& mesh, Face f) {
  require(mesh.has_face_status(), "open_curve: the mesh needs face status to mark what is deleted");
  if (const char* reason = reason_against_opening(mesh, f))
    throw ContractViolation(std::string("open_curve: ") + reason);
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

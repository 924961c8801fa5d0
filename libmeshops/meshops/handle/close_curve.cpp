#include "meshops/handle/close_curve.h"

#include "meshops/core/contract.h"
#include "meshops/core/fans.h"
#include "meshops/core/live.h"
#include "meshops/handle/unchecked.h"

namespace meshops {
namespace {

/// Returns whether another side of the face of `h` starts at the same vertex as `h`.
bool is_passed_again(const Connectivity& mesh, Halfedge h) {
  const Face f = mesh.face_handle(h);
  for (Halfedge out = h;;) {
    out = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(out));
    if (out == h) return false;
    if (mesh.face_handle(out) == f) return true;
  }
}

}  // namespace

std::optional<Blocker> close_curve_blocker(const Connectivity& mesh, Halfedge h) {
  if (!is_live(mesh, h)) return Blocker(BlockerKind::missing, h);
  if (!mesh.is_boundary(h)) return Blocker(BlockerKind::not_on_boundary, h);
  if (mesh.next_halfedge_handle(mesh.next_halfedge_handle(h)) == h) return Blocker(BlockerKind::curve_too_short, h);
  Halfedge side = h;
  do {
    if (detail::has_other_fans(mesh, side)) return Blocker(BlockerKind::several_fans, mesh.from_vertex_handle(side));
    side = mesh.next_halfedge_handle(side);
  } while (side != h);
  return std::nullopt;
}

CloseCurveEffect close_curve(Connectivity& mesh, Halfedge h) {
  detail::enforce("close_curve", close_curve_blocker(mesh, h));
  const Face f = mesh.new_face();
  mesh.set_halfedge_handle(f, h);
  Halfedge side = h;
  do {
    mesh.set_face_handle(side, f);
    side = mesh.next_halfedge_handle(side);
  } while (side != h);
  return {f};
}

std::optional<Blocker> open_curve_blocker(const Connectivity& mesh, Face f) {
  if (!mesh.has_face_status()) return Blocker(BlockerKind::no_status);
  if (!is_live(mesh, f)) return Blocker(BlockerKind::missing, f);
  const Halfedge first = mesh.halfedge_handle(f);
  Halfedge h = first;
  std::size_t sides = 0;
  do {
    const Halfedge beyond = mesh.opposite_halfedge_handle(h);
    const Vertex corner = mesh.from_vertex_handle(h);
    if (mesh.is_boundary(beyond)) return Blocker(BlockerKind::on_boundary, mesh.edge_handle(h));
    if (mesh.is_boundary(corner)) return Blocker(BlockerKind::on_boundary, corner);
    if (mesh.face_handle(beyond) == f) return Blocker(BlockerKind::face_on_both_sides, f);
    ++sides;
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  if (sides == 3) return std::nullopt;  // no edge is a loop, so that the three corners are distinct vertices
  do {
    if (is_passed_again(mesh, h)) return Blocker(BlockerKind::corner_repeated, mesh.from_vertex_handle(h));
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  return std::nullopt;
}

OpenCurveEffect open_curve(Connectivity& mesh, Face f) {
  detail::enforce("open_curve", open_curve_blocker(mesh, f));
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

#include "meshops/stellar/weld_edge.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

/// Returns the halfedge that continues the edge of h beyond the start of h. It leaves the start of h two edges farther
/// around: counter-clockwise, or clockwise if h is a boundary halfedge.
Halfedge beyond(const Connectivity& mesh, Halfedge h) {
  return mesh.is_boundary(h) ? detail::cw(mesh, detail::cw(mesh, h)) : detail::ccw(mesh, detail::ccw(mesh, h));
}

}  // namespace

std::optional<Blocker> weld_edge_blocker(const Connectivity& mesh, Halfedge h, Keep keep) {
  if (const auto reason = detail::status_blocker(mesh)) return reason;
  if (!is_live(mesh, h)) return Blocker(BlockerKind::missing, h);
  const Vertex v = mesh.from_vertex_handle(h);
  const Halfedge far = beyond(mesh, h);
  if (mesh.is_boundary(v)) {
    if (!mesh.is_boundary(mesh.edge_handle(h))) return Blocker(BlockerKind::not_on_boundary, mesh.edge_handle(h));
    if (far == h || !mesh.is_boundary(mesh.edge_handle(far))) return Blocker(BlockerKind::wrong_degree, v, 3);
  } else if (far == h || beyond(mesh, far) != h) {
    return Blocker(BlockerKind::wrong_degree, v, 4);
  }
  for (const Halfedge side : {far, mesh.opposite_halfedge_handle(far)})
    if (!mesh.is_boundary(side) && !detail::is_triangle(mesh, side))
      return Blocker(BlockerKind::not_triangle, mesh.face_handle(side));
  return detail::close_blocker(mesh, h, keep);
}

WeldEdgeEffect weld_edge(Connectivity& mesh, Halfedge h, Keep keep) {
  detail::enforce("weld_edge", weld_edge_blocker(mesh, h, keep));
  const Halfedge line = mesh.opposite_halfedge_handle(beyond(mesh, h));
  return {detail::close_edge(mesh, h), line};
}

}  // namespace meshops

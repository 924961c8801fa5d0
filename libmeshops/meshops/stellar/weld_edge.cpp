#include "meshops/stellar/weld_edge.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

/// Returns the halfedge that continues the edge of h beyond the start of h. It leaves the same vertex, two triangles
/// farther around it: counter-clockwise, or clockwise if h is a boundary halfedge.
Halfedge beyond(const Connectivity& mesh, Halfedge h) {
  return mesh.is_boundary(h) ? detail::cw(mesh, detail::cw(mesh, h)) : detail::ccw(mesh, detail::ccw(mesh, h));
}

const char* weld_edge_refusal(const Connectivity& mesh, Halfedge h, Keep keep) {
  if (const char* reason = detail::status_refusal(mesh)) return reason;
  if (!is_live(mesh, h)) return "the halfedge does not exist or is deleted";
  const Vertex v = mesh.from_vertex_handle(h);
  const Halfedge far = beyond(mesh, h);
  if (mesh.is_boundary(v)) {
    if (!mesh.is_boundary(mesh.edge_handle(h))) return "the vertex is on the boundary and the edge is not";
    if (far == h || !mesh.is_boundary(mesh.edge_handle(far))) return "the boundary vertex does not have three edges";
  } else if (far == h || beyond(mesh, far) != h) {
    return "the vertex does not have four edges";
  }
  for (const Halfedge side : {far, mesh.opposite_halfedge_handle(far)})
    if (!mesh.is_boundary(side) && !detail::is_triangle(mesh, side)) return "a face is not a triangle";
  return detail::close_refusal(mesh, h, keep);
}

}  // namespace

std::optional<std::string> weld_edge_blocker(const Connectivity& mesh, Halfedge h, Keep keep) {
  return detail::as_blocker(weld_edge_refusal(mesh, h, keep));
}

WeldEdgeEffect weld_edge(Connectivity& mesh, Halfedge h, Keep keep) {
  detail::enforce("weld_edge", weld_edge_refusal(mesh, h, keep));
  const Halfedge line = mesh.opposite_halfedge_handle(beyond(mesh, h));
  return {detail::close_edge(mesh, h), line};
}

}  // namespace meshops

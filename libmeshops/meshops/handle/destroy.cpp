#include "meshops/handle/destroy.h"

#include <array>

#include "meshops/core/contract.h"
#include "meshops/core/fans.h"
#include "meshops/core/live.h"
#include "meshops/handle/unchecked.h"

namespace meshops {
namespace {

std::optional<Blocker> blocker_of_any(const Connectivity& mesh, Face f) {
  if (const auto reason = detail::status_blocker(mesh)) return reason;
  if (!is_live(mesh, f)) return Blocker(BlockerKind::missing, f);
  const Halfedge first = mesh.halfedge_handle(f);
  const Halfedge third = mesh.next_halfedge_handle(mesh.next_halfedge_handle(first));
  return mesh.next_halfedge_handle(third) == first ? std::nullopt
                                                   : std::optional(Blocker(BlockerKind::not_triangle, f));
}

std::array<Halfedge, 3> sides_of_triangle(const Connectivity& mesh, Face f) {
  const Halfedge first = mesh.halfedge_handle(f), second = mesh.next_halfedge_handle(first);
  return {first, second, mesh.next_halfedge_handle(second)};
}

void destroy(Connectivity& mesh, Face f) {
  for (const Halfedge side : sides_of_triangle(mesh, f)) {
    mesh.status(mesh.from_vertex_handle(side)).set_deleted(true);
    mesh.set_isolated(mesh.from_vertex_handle(side));
    mesh.status(mesh.edge_handle(side)).set_deleted(true);
    mesh.status(side).set_deleted(true);
    mesh.status(mesh.opposite_halfedge_handle(side)).set_deleted(true);
  }
  mesh.status(f).set_deleted(true);
}

}  // namespace

std::optional<Blocker> destroy_triangle_blocker(const Connectivity& mesh, Face f) {
  if (const auto reason = blocker_of_any(mesh, f)) return reason;
  const auto beyond = [&](Halfedge side) { return mesh.opposite_halfedge_handle(side); };
  for (const Halfedge side : sides_of_triangle(mesh, f))
    if (!mesh.is_boundary(beyond(side))) return Blocker(BlockerKind::not_on_boundary, mesh.edge_handle(side));
  // The boundary runs around the triangle alone, unless it continues to another fan at a corner.
  for (const Halfedge side : sides_of_triangle(mesh, f))
    if (mesh.prev_halfedge_handle(beyond(side)) != beyond(mesh.next_halfedge_handle(side)))
      return Blocker(BlockerKind::several_fans, mesh.to_vertex_handle(side));
  return std::nullopt;
}

Delta destroy_triangle(Connectivity& mesh, Face f) {
  detail::enforce("destroy_triangle", destroy_triangle_blocker(mesh, f));
  destroy(mesh, f);
  return delta_of_destroy();
}

std::optional<Blocker> remove_triangle_blocker(const Connectivity& mesh, Face f) {
  if (const auto reason = blocker_of_any(mesh, f)) return reason;
  for (const Halfedge side : sides_of_triangle(mesh, f))
    if (const Vertex v = mesh.from_vertex_handle(side); has_several_fans(mesh, v))
      return Blocker(BlockerKind::several_fans, v);
  return std::nullopt;
}

Delta remove_triangle(Connectivity& mesh, Face f) {
  detail::enforce("remove_triangle", remove_triangle_blocker(mesh, f));
  Delta delta;
  // unglue() of a side leaves the old edge and the old vertices to the face beyond the side.
  for (const Halfedge side : sides_of_triangle(mesh, f)) {
    const Halfedge beyond = mesh.opposite_halfedge_handle(side);
    if (!mesh.is_boundary(beyond)) delta = delta + detail::unglue_links(mesh, side).delta();
  }
  destroy(mesh, f);
  return delta + delta_of_destroy();
}

}  // namespace meshops

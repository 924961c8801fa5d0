#include "meshops/handle/glue.h"

#include "meshops/core/contract.h"
#include "meshops/core/fans.h"
#include "meshops/core/live.h"
#include "meshops/core/reach.h"
#include "meshops/handle/fan.h"
#include "meshops/handle/unchecked.h"

namespace meshops {
namespace {

/// Returns why the vertex that the boundary halfedge `out` leaves cannot become one with `other`, or nothing when it
/// can. Walks once around the vertex.
std::optional<Blocker> blocker_at(const Connectivity& mesh, Halfedge out, Vertex other) {
  for (Halfedge h = out;;) {
    if (mesh.to_vertex_handle(h) == other) return Blocker(BlockerKind::loop_edge, mesh.edge_handle(h));
    const Halfedge in = mesh.opposite_halfedge_handle(h);
    h = mesh.next_halfedge_handle(in);
    if (mesh.is_boundary(in))
      return h == out ? std::nullopt : std::optional(Blocker(BlockerKind::several_fans, mesh.from_vertex_handle(out)));
  }
}

/// Merges the fans of two boundary vertices, and marks the vertex of the higher handle deleted. Returns: the other.
Vertex merge(Connectivity& mesh, Vertex a, Vertex b) {
  if (a == b) return a;
  const Vertex survivor = a.idx() < b.idx() ? a : b;
  const Vertex loser = a.idx() < b.idx() ? b : a;
  detail::move_fan(mesh, mesh.halfedge_handle(loser), survivor);
  mesh.set_isolated(loser);
  mesh.status(loser).set_deleted(true);
  return survivor;
}

}  // namespace

namespace detail {

std::optional<Blocker> merge_blocker(const Connectivity& mesh, Halfedge out, Halfedge other_out) {
  if (out != other_out)
    if (const auto reason = blocker_at(mesh, out, mesh.from_vertex_handle(other_out))) return reason;
  if (has_other_fans(mesh, other_out)) return Blocker(BlockerKind::several_fans, mesh.from_vertex_handle(other_out));
  return std::nullopt;
}

std::optional<Blocker> boundary_blocker(const Connectivity& mesh, Halfedge first, Halfedge second) {
  for (const Halfedge h : {first, second})
    if (!is_live(mesh, h)) return Blocker(BlockerKind::missing, h);
  for (const Halfedge h : {first, second})
    if (!mesh.is_boundary(h)) return Blocker(BlockerKind::not_on_boundary, h);
  return std::nullopt;
}

std::optional<Blocker> glue_links_blocker(const Connectivity& mesh, Halfedge first, Halfedge second) {
  if (is_live(mesh, first) && mesh.edge_handle(first) == mesh.edge_handle(second))
    return Blocker(BlockerKind::same_edge, mesh.edge_handle(first));
  if (const auto reason = boundary_blocker(mesh, first, second)) return reason;
  if (const auto reason = merge_blocker(mesh, first, mesh.next_halfedge_handle(second))) return reason;
  return merge_blocker(mesh, mesh.next_halfedge_handle(first), second);
}

GlueCase case_of_glue(const Connectivity& mesh, Halfedge first, Halfedge second) {
  const bool adjacent_at_end = mesh.next_halfedge_handle(first) == second;
  const bool adjacent_at_start = mesh.next_halfedge_handle(second) == first;
  if (adjacent_at_end && adjacent_at_start) return GlueCase::close;
  if (adjacent_at_end || adjacent_at_start) return GlueCase::zip;
  if (on_same_curve(mesh, first, second)) return GlueCase::split_curve;
  const auto face_at = [&](Halfedge h) { return mesh.face_handle(mesh.opposite_halfedge_handle(h)); };
  return in_same_component(mesh, face_at(first), face_at(second)) ? GlueCase::handle : GlueCase::join;
}

GlueEffect glue_links(Connectivity& mesh, Halfedge first, Halfedge second, GlueCase what) {
  const GlueEffect effect{what,
                          first,
                          second,
                          {mesh.from_vertex_handle(first), mesh.to_vertex_handle(first)},
                          {mesh.from_vertex_handle(second), mesh.to_vertex_handle(second)}};
  const Halfedge before_first = mesh.prev_halfedge_handle(first), after_first = mesh.next_halfedge_handle(first);
  const Halfedge before_second = mesh.prev_halfedge_handle(second), after_second = mesh.next_halfedge_handle(second);
  const Halfedge inner = mesh.opposite_halfedge_handle(second);  // the halfedge that `first` replaces
  const Halfedge inner_before = mesh.prev_halfedge_handle(inner), inner_after = mesh.next_halfedge_handle(inner);
  const Face face = mesh.face_handle(inner);

  const Vertex start = merge(mesh, effect.first_ends.from, effect.second_ends.to);
  const Vertex end = merge(mesh, effect.first_ends.to, effect.second_ends.from);

  // `first` replaces `inner`, the opposite of `second`, in the face of `inner`.
  mesh.set_face_handle(first, face);
  if (mesh.halfedge_handle(face) == inner) mesh.set_halfedge_handle(face, first);
  mesh.set_next_halfedge_handle(inner_before, first);
  mesh.set_next_halfedge_handle(first, inner_after);

  // At each end, the boundary passes the glued edge, unless the curve closes there.
  if (after_first == second) {
    mesh.set_halfedge_handle(end, mesh.opposite_halfedge_handle(first));
  } else {
    mesh.set_next_halfedge_handle(before_second, after_first);
    mesh.set_halfedge_handle(end, after_first);
  }
  if (after_second == first) {
    mesh.set_halfedge_handle(start, first);
  } else {
    mesh.set_next_halfedge_handle(before_first, after_second);
    mesh.set_halfedge_handle(start, after_second);
  }

  mesh.status(mesh.edge_handle(second)).set_deleted(true);
  mesh.status(second).set_deleted(true);
  mesh.status(inner).set_deleted(true);
  return effect;
}

}  // namespace detail

std::optional<Blocker> glue_blocker(const Connectivity& mesh, Halfedge first, Halfedge second) {
  const auto reason = detail::status_blocker(mesh);
  return reason ? reason : detail::glue_links_blocker(mesh, first, second);
}

GlueCase glue_case(const Connectivity& mesh, Halfedge first, Halfedge second) {
  detail::enforce("glue_case", detail::glue_links_blocker(mesh, first, second));
  return detail::case_of_glue(mesh, first, second);
}

GlueEffect glue(Connectivity& mesh, Halfedge first, Halfedge second) {
  detail::enforce("glue", glue_blocker(mesh, first, second));
  return detail::glue_links(mesh, first, second, detail::case_of_glue(mesh, first, second));
}

GlueEffect glue(Connectivity& mesh, Halfedge first, Halfedge second, GlueCase what) {
  detail::enforce("glue", glue_blocker(mesh, first, second));
  return detail::glue_links(mesh, first, second, what);
}

}  // namespace meshops

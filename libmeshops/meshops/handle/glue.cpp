#include "meshops/handle/glue.h"

#include "meshops/core/contract.h"
#include "meshops/core/fans.h"
#include "meshops/core/live.h"
#include "meshops/core/reach.h"
#include "meshops/handle/fan.h"
#include "meshops/handle/unchecked.h"

namespace meshops {
namespace {

/// Returns why the vertex that the boundary halfedge `out` leaves cannot become one with `other`, or nullptr when it
/// can. Walks once through the fan of the vertex.
const char* reason_at(const Connectivity& mesh, Halfedge out, Vertex other) {
  for (Halfedge h = out;;) {
    if (mesh.to_vertex_handle(h) == other) return "an edge joins two vertices that would become one";
    const Halfedge in = mesh.opposite_halfedge_handle(h);
    h = mesh.next_halfedge_handle(in);
    if (mesh.is_boundary(in)) return h == out ? nullptr : detail::several_fans;
  }
}

/// Merges the fans of two boundary vertices and returns the survivor.
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

const char* merge_refusal(const Connectivity& mesh, Halfedge out, Halfedge other_out) {
  if (out != other_out)
    if (const char* reason = reason_at(mesh, out, mesh.from_vertex_handle(other_out))) return reason;
  return has_other_fans(mesh, other_out) ? several_fans : nullptr;
}

const char* glue_refusal(const Connectivity& mesh, Halfedge first, Halfedge second) {
  if (!is_live(mesh, first) || !is_live(mesh, second)) return "a halfedge does not exist or is deleted";
  if (mesh.edge_handle(first) == mesh.edge_handle(second)) return "both halfedges are of one edge";
  if (!mesh.is_boundary(first) || !mesh.is_boundary(second)) return "a halfedge is not on the boundary";
  if (const char* reason = merge_refusal(mesh, first, mesh.next_halfedge_handle(second))) return reason;
  return merge_refusal(mesh, mesh.next_halfedge_handle(first), second);
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

  // `first` replaces the opposite of `second` in its face.
  mesh.set_face_handle(first, face);
  if (mesh.halfedge_handle(face) == inner) mesh.set_halfedge_handle(face, first);
  mesh.set_next_halfedge_handle(inner_before, first);
  mesh.set_next_halfedge_handle(first, inner_after);

  // The boundary passes by the glued edge at each end, unless the curve closes there.
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

namespace {

const char* refusal(const Connectivity& mesh, Halfedge first, Halfedge second) {
  const char* reason = detail::status_refusal(mesh);
  return reason != nullptr ? reason : detail::glue_refusal(mesh, first, second);
}

}  // namespace

std::optional<std::string> glue_blocker(const Connectivity& mesh, Halfedge first, Halfedge second) {
  return detail::as_blocker(refusal(mesh, first, second));
}

GlueCase glue_case(const Connectivity& mesh, Halfedge first, Halfedge second) {
  detail::enforce("glue_case", detail::glue_refusal(mesh, first, second));
  return detail::case_of_glue(mesh, first, second);
}

GlueEffect glue(Connectivity& mesh, Halfedge first, Halfedge second) {
  detail::enforce("glue", refusal(mesh, first, second));
  return detail::glue_links(mesh, first, second, detail::case_of_glue(mesh, first, second));
}

GlueEffect glue(Connectivity& mesh, Halfedge first, Halfedge second, GlueCase what) {
  detail::enforce("glue", refusal(mesh, first, second));
  return detail::glue_links(mesh, first, second, what);
}

}  // namespace meshops

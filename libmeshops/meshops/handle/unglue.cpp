#include "meshops/handle/unglue.h"

#include <algorithm>

#include "meshops/core/contract.h"
#include "meshops/core/fans.h"
#include "meshops/core/live.h"
#include "meshops/core/reach.h"
#include "meshops/handle/fan.h"
#include "meshops/handle/unchecked.h"

namespace meshops {
namespace {

/// One end of the edge to unglue, and the boundary halfedges at this end, if there are any.
struct End {
  Vertex vertex;
  Halfedge before, after;  // boundary halfedges into the vertex and out of it
  bool on_boundary;

  /// Reads the end at `v`. Requires: `v` has one fan; not checked.
  End(const Connectivity& mesh, Vertex v) : vertex(v), on_boundary(mesh.is_boundary(v)) {
    if (!on_boundary) return;
    after = mesh.halfedge_handle(v);
    before = mesh.prev_halfedge_handle(after);
  }
};

/// Elements after the split: the second edge, and for each end of the edge the vertices of its two fans.
struct Parts {
  Halfedge second;
  GlueEffect::Ends first_ends;
  GlueEffect::Ends second_ends;
};

/// Splits the edge of `first`; changes only records. Requires: every element of `parts` is live, and no record refers
/// to the edge of `parts.second` yet; not checked.
void part(Connectivity& mesh, Halfedge first, const End& start, const End& end, const Parts& parts) {
  const Halfedge second = parts.second, inner = mesh.opposite_halfedge_handle(second);
  const Halfedge before = mesh.prev_halfedge_handle(first), after = mesh.next_halfedge_handle(first);
  const Face face = mesh.face_handle(first);

  // The new edge replaces `first` in its face.
  mesh.set_face_handle(inner, face);
  if (mesh.halfedge_handle(face) == first) mesh.set_halfedge_handle(face, inner);
  mesh.set_next_halfedge_handle(before, inner);
  mesh.set_next_halfedge_handle(inner, after);
  mesh.set_vertex_handle(inner, end.vertex);
  mesh.set_vertex_handle(second, start.vertex);
  mesh.set_boundary(first);
  mesh.set_boundary(second);

  // At a boundary end, the boundary passes through the gap instead of along the edge; at an inner end, the gap begins.
  if (start.on_boundary) {
    mesh.set_next_halfedge_handle(start.before, first);
    mesh.set_next_halfedge_handle(second, start.after);
    mesh.set_halfedge_handle(parts.first_ends.from, first);
    mesh.set_halfedge_handle(parts.second_ends.to, start.after);
  } else {
    mesh.set_next_halfedge_handle(second, first);
    mesh.set_halfedge_handle(start.vertex, first);
  }
  if (end.on_boundary) {
    mesh.set_next_halfedge_handle(end.before, second);
    mesh.set_next_halfedge_handle(first, end.after);
    mesh.set_halfedge_handle(parts.first_ends.to, end.after);
    mesh.set_halfedge_handle(parts.second_ends.from, second);
  } else {
    mesh.set_next_halfedge_handle(first, second);
    mesh.set_halfedge_handle(end.vertex, second);
  }

  // One of the two fans at each boundary end moves to the other vertex.
  for (const Vertex v : {parts.first_ends.from, parts.second_ends.to})
    if (v != start.vertex) detail::move_fan(mesh, mesh.halfedge_handle(v), v);
  for (const Vertex v : {parts.first_ends.to, parts.second_ends.from})
    if (v != end.vertex) detail::move_fan(mesh, mesh.halfedge_handle(v), v);
}

Vertex copy_of(Connectivity& mesh, Vertex v) {
  const Vertex copy = mesh.new_vertex();
  mesh.copy_all_properties(v, copy, true);
  return copy;
}

Halfedge copy_of_edge(Connectivity& mesh, Halfedge h) {
  const Halfedge o = mesh.opposite_halfedge_handle(h);
  const Halfedge copy = mesh.new_edge(mesh.from_vertex_handle(h), mesh.to_vertex_handle(h));
  const Halfedge copy_of_o = mesh.opposite_halfedge_handle(copy);
  mesh.copy_all_properties(mesh.edge_handle(h), mesh.edge_handle(copy), true);
  mesh.copy_all_properties(h, copy, true);
  mesh.copy_all_properties(o, copy_of_o, true);
  return copy_of_o;
}

GlueCase case_of_unglue(const Connectivity& mesh, Halfedge h, const End& start, const End& end) {
  if (!start.on_boundary && !end.on_boundary) return GlueCase::close;
  if (!start.on_boundary || !end.on_boundary) return GlueCase::zip;
  if (!on_same_curve(mesh, start.after, end.after)) return GlueCase::split_curve;
  const Face one = mesh.face_handle(h), other = mesh.face_handle(mesh.opposite_halfedge_handle(h));
  return in_same_component(mesh, one, other, mesh.edge_handle(h)) ? GlueCase::handle : GlueCase::join;
}

}  // namespace

namespace detail {

UnglueEffect unglue_links(Connectivity& mesh, Halfedge h) {
  const End start(mesh, mesh.from_vertex_handle(h)), end(mesh, mesh.to_vertex_handle(h));
  const GlueCase what = case_of_unglue(mesh, h, start, end);
  const Halfedge second = copy_of_edge(mesh, h);
  UnglueEffect effect{what, h, second, Vertex(), Vertex()};
  if (start.on_boundary) effect.new_start = copy_of(mesh, start.vertex);
  if (end.on_boundary) effect.new_end = copy_of(mesh, end.vertex);
  const auto other = [](Vertex copy, const End& at) { return copy.is_valid() ? copy : at.vertex; };
  part(mesh, h, start, end,
       {second, {start.vertex, end.vertex}, {other(effect.new_end, end), other(effect.new_start, start)}});
  return effect;
}

}  // namespace detail

std::optional<Blocker> unglue_blocker(const Connectivity& mesh, Halfedge h) {
  if (!is_live(mesh, h)) return Blocker(BlockerKind::missing, h);
  if (mesh.is_boundary(mesh.edge_handle(h))) return Blocker(BlockerKind::on_boundary, mesh.edge_handle(h));
  for (const Vertex end : {mesh.from_vertex_handle(h), mesh.to_vertex_handle(h)})
    if (has_several_fans(mesh, end)) return Blocker(BlockerKind::several_fans, end);
  return std::nullopt;
}

GlueCase unglue_case(const Connectivity& mesh, Halfedge h) {
  detail::enforce("unglue_case", unglue_blocker(mesh, h));
  return case_of_unglue(mesh, h, End(mesh, mesh.from_vertex_handle(h)), End(mesh, mesh.to_vertex_handle(h)));
}

UnglueEffect unglue(Connectivity& mesh, Halfedge h) {
  detail::enforce("unglue", unglue_blocker(mesh, h));
  return detail::unglue_links(mesh, h);
}

UnglueEffect unglue(Connectivity& mesh, const GlueEffect& effect) {
  detail::require_status(mesh, "unglue");
  const Halfedge h = effect.survivor;
  detail::enforce("unglue", unglue_blocker(mesh, h));
  const End start(mesh, mesh.from_vertex_handle(h)), end(mesh, mesh.to_vertex_handle(h));
  const auto is_dead = [&](auto element, std::size_t count) {
    return element.is_valid() && static_cast<std::size_t>(element.idx()) < count && !is_live(mesh, element);
  };
  /// Returns the vertex that glue() marked deleted at an end, or an invalid handle if it merged none there.
  const auto deleted_at = [](Vertex a, Vertex b) { return a == b ? Vertex() : std::max(a, b); };
  const auto fits = [&](const End& at, Vertex a, Vertex b) {
    const Vertex gone = deleted_at(a, b);
    return at.vertex == std::min(a, b) && at.on_boundary == gone.is_valid() &&
           (!gone.is_valid() || is_dead(gone, mesh.n_vertices()));
  };
  const Vertex new_start = deleted_at(effect.first_ends.from, effect.second_ends.to);
  const Vertex new_end = deleted_at(effect.first_ends.to, effect.second_ends.from);
  require(is_dead(effect.removed, mesh.n_halfedges()) && fits(start, effect.first_ends.from, effect.second_ends.to) &&
              fits(end, effect.first_ends.to, effect.second_ends.from) &&
              (new_start != new_end || !new_start.is_valid()),
          "unglue: the edge is no longer as glue() left it");

  const UnglueEffect result{case_of_unglue(mesh, h, start, end), h, effect.removed, new_start, new_end};
  for (const Vertex v : {result.new_start, result.new_end})
    if (v.is_valid()) mesh.status(v).set_deleted(false);
  mesh.status(mesh.edge_handle(effect.removed)).set_deleted(false);
  mesh.status(effect.removed).set_deleted(false);
  mesh.status(mesh.opposite_halfedge_handle(effect.removed)).set_deleted(false);
  part(mesh, h, start, end, {effect.removed, effect.first_ends, effect.second_ends});
  return result;
}

}  // namespace meshops

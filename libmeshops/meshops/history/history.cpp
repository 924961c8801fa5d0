#include "meshops/history/history.h"

#include "meshops/core/live.h"
#include "meshops/handle/destroy.h"
#include "meshops/stellar/undo.h"

namespace meshops {
namespace {

void revive(Connectivity& mesh, Edge e) {
  mesh.status(e).set_deleted(false);
  for (const unsigned side : {0U, 1U}) mesh.status(mesh.halfedge_handle(e, side)).set_deleted(false);
}

std::vector<Halfedge> sides_of(const Connectivity& mesh, Face f) {
  std::vector<Halfedge> sides;
  const Halfedge first = mesh.halfedge_handle(f);
  Halfedge h = first;
  do {
    sides.push_back(h);
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  return sides;
}

std::vector<Vertex> corners_of(const Connectivity& mesh, Face f) {
  std::vector<Vertex> corners;
  for (const Halfedge side : sides_of(mesh, f)) corners.push_back(mesh.from_vertex_handle(side));
  return corners;
}

/// Undoes destroy_triangle(), which changed no record of the triangle except the halfedges of its corners. The halfedge
/// of a corner was the only boundary halfedge that leaves the corner.
void revive(Connectivity& mesh, Face f) {
  mesh.status(f).set_deleted(false);
  for (const Halfedge side : sides_of(mesh, f)) {
    revive(mesh, mesh.edge_handle(side));
    mesh.status(mesh.to_vertex_handle(side)).set_deleted(false);
    mesh.set_halfedge_handle(mesh.to_vertex_handle(side), mesh.opposite_halfedge_handle(side));
  }
}

}  // namespace

History::History(Connectivity& mesh) : mesh_(mesh) { detail::require_status(mesh, "History"); }

CreateTriangleEffect History::create_triangle() {
  return perform<CreateTriangleEffect>([this] {
    const CreateTriangleEffect effect = meshops::create_triangle(mesh_);
    return std::pair(effect, [this, f = effect.face] { meshops::destroy_triangle(mesh_, f); });
  });
}

Delta History::destroy_triangle(Face f) {
  return perform<Delta>([this, f] {
    const Delta delta = meshops::destroy_triangle(mesh_, f);
    return std::pair(delta, [this, f] { revive(mesh_, f); });
  });
}

Delta History::remove_triangle(Face f) {
  return perform<Delta>([this, f] {
    detail::enforce("remove_triangle", remove_triangle_blocker(mesh_, f));
    const std::vector<Halfedge> sides = sides_of(mesh_, f);
    const Undo name = named_again(corners_of(mesh_, f));
    Delta delta;
    std::vector<UnglueEffect> unglued;
    for (const Halfedge side : sides)
      if (!mesh_.is_boundary(mesh_.opposite_halfedge_handle(side))) {
        unglued.push_back(meshops::unglue(mesh_, side));
        delta = delta + unglued.back().delta();
      }
    delta = delta + meshops::destroy_triangle(mesh_, f);
    return std::pair(delta, [this, f, unglued, name] {
      revive(mesh_, f);
      for (auto one = unglued.rbegin(); one != unglued.rend(); ++one)
        meshops::glue(mesh_, one->first, one->second, one->what);
      name();
    });
  });
}

ZipCurvesEffect History::zip_curves(Halfedge first, Halfedge second) {
  return perform<ZipCurvesEffect>([this, first, second] {
    const ZipCurvesEffect effect = meshops::zip_curves(mesh_, first, second);
    return std::pair(effect, [this, effect] { meshops::undo(mesh_, effect); });
  });
}

GlueEffect History::glue(Halfedge first, Halfedge second) {
  return perform<GlueEffect>([this, first, second] {
    // glue() isolates the vertices that it marks deleted; unglue() finds the halfedges that these vertices had.
    const GlueEffect effect = meshops::glue(mesh_, first, second);
    return std::pair(effect, [this, effect] { meshops::unglue(mesh_, effect); });
  });
}

UnglueEffect History::unglue(Halfedge h) {
  return perform<UnglueEffect>([this, h] {
    detail::enforce("unglue", unglue_blocker(mesh_, h));
    const Undo name = named_again({mesh_.from_vertex_handle(h), mesh_.to_vertex_handle(h)});
    const UnglueEffect effect = meshops::unglue(mesh_, h);
    return std::pair(effect, [this, effect, name] {
      meshops::glue(mesh_, effect.first, effect.second, effect.what);
      name();
    });
  });
}

CloseCurveEffect History::close_curve(Halfedge h) {
  return perform<CloseCurveEffect>([this, h] {
    const CloseCurveEffect effect = meshops::close_curve(mesh_, h);
    return std::pair(effect, [this, effect] { meshops::open_curve(mesh_, effect.face); });
  });
}

OpenCurveEffect History::open_curve(Face f) {
  return perform<OpenCurveEffect>([this, f] {
    detail::enforce("open_curve", open_curve_blocker(mesh_, f));
    const Undo name = named_again(corners_of(mesh_, f));
    const OpenCurveEffect effect = meshops::open_curve(mesh_, f);
    return std::pair(effect, [this, f, name] {
      mesh_.status(f).set_deleted(false);
      for (const Halfedge side : sides_of(mesh_, f)) mesh_.set_face_handle(side, f);
      name();
    });
  });
}

FlipEffect History::flip(Edge e, Keep keep) {
  return perform<FlipEffect>([this, e, keep] {
    const FlipEffect effect = meshops::flip(mesh_, e, keep);
    return std::pair(effect, [this, effect] { meshops::undo(mesh_, effect); });
  });
}

WeldEffect History::collapse(Halfedge h, Keep keep) {
  return weld([this, h, keep] { return meshops::collapse(mesh_, h, keep); });
}

WeldEdgeEffect History::weld_edge(Halfedge h, Keep keep) {
  return weld([this, h, keep] { return meshops::weld_edge(mesh_, h, keep); });
}

WeldFaceEffect History::weld_face(Vertex v, Keep keep) {
  return weld([this, v, keep] { return meshops::weld_face(mesh_, v, keep); });
}

WeldEffect History::remove_vertex(Vertex v, Keep keep) {
  return weld([this, v, keep] { return meshops::remove_vertex(mesh_, v, keep); });
}

InsertDiagonalEffect History::insert_diagonal(Halfedge from, Halfedge to, Keep keep) {
  return perform<InsertDiagonalEffect>([this, from, to, keep] {
    const InsertDiagonalEffect effect = meshops::insert_diagonal(mesh_, from, to, keep);
    return std::pair(effect, [this, effect] { meshops::remove_diagonal(mesh_, effect.diagonal); });
  });
}

RemoveDiagonalEffect History::remove_diagonal(Halfedge h) {
  return perform<RemoveDiagonalEffect>([this, h] {
    detail::enforce("remove_diagonal", remove_diagonal_blocker(mesh_, h));
    const Halfedge o = mesh_.opposite_halfedge_handle(h);
    const Halfedge named = mesh_.halfedge_handle(mesh_.face_handle(o));
    const std::vector<Halfedge> before = {mesh_.prev_halfedge_handle(h), mesh_.prev_halfedge_handle(o)};
    const Undo name = named_again({mesh_.from_vertex_handle(h), mesh_.to_vertex_handle(h)});
    const RemoveDiagonalEffect effect = meshops::remove_diagonal(mesh_, h);
    return std::pair(effect, [this, effect, h, o, named, before, name] {
      // The diagonal and its face still have their old records. The neighboring sides are linked past the diagonal.
      revive(mesh_, effect.edge);
      mesh_.status(effect.face).set_deleted(false);
      mesh_.set_next_halfedge_handle(before[0], h);
      mesh_.set_next_halfedge_handle(h, effect.to);
      mesh_.set_next_halfedge_handle(before[1], o);
      mesh_.set_next_halfedge_handle(o, effect.from);
      for (const Halfedge side : sides_of(mesh_, effect.face)) mesh_.set_face_handle(side, effect.face);
      mesh_.set_halfedge_handle(effect.survivor, named);
      name();
    });
  });
}

SplitEdgeEffect History::split_edge(Halfedge h, Keep keep) {
  return split([this, h, keep] { return meshops::split_edge(mesh_, h, keep); });
}

SplitFaceEffect History::split_face(Face f) {
  return split([this, f] { return meshops::split_face(mesh_, f); });
}

SplitVertexEffect History::split_vertex(std::optional<Halfedge> left, std::optional<Halfedge> right, Keep keep) {
  return split([this, left, right, keep] { return meshops::split_vertex(mesh_, left, right, keep); });
}

History::Undo History::undo_of_split(Halfedge halfedge) {
  return [this, halfedge] { meshops::collapse(mesh_, halfedge, Keep::manifold); };
}

History::Undo History::undo_of_diagonals(const std::vector<Halfedge>& diagonals) {
  return [this, diagonals] {
    for (auto diagonal = diagonals.rbegin(); diagonal != diagonals.rend(); ++diagonal)
      meshops::remove_diagonal(mesh_, *diagonal);
  };
}

History::Undo History::undo_of_weld(const WeldEffect& effect) {
  return [this, effect] { meshops::undo(mesh_, effect); };
}

/// Returns a function that sets the halfedges of the given vertices to their values at this call.
History::Undo History::named_again(std::vector<Vertex> vertices) const {
  std::vector<Halfedge> named;
  for (const Vertex v : vertices) named.push_back(mesh_.halfedge_handle(v));
  return [&mesh = mesh_, vertices = std::move(vertices), named = std::move(named)] {
    for (std::size_t i = 0; i < vertices.size(); ++i) mesh.set_halfedge_handle(vertices[i], named[i]);
  };
}

void History::require_own() const {
  if (done_.empty() && undone_.empty()) return;
  require(ElementCounts::of(mesh_) == (done_.empty() ? undone_.back().before : done_.back().after),
          "History: the number of elements differs from that after the last step: the mesh was "
          "changed by others");
}

void History::remember(Step step) {
  undone_.clear();
  done_.push_back(std::move(step));
}

void History::undo() {
  require(!done_.empty(), "History: there is no step to undo");
  require_own();
  Step& step = done_.back();
  step.back();
  // The elements that the step added are deleted now, and no live element follows them.
  mesh_.resize(step.before.vertices, step.before.edges, step.before.faces);
  undone_.push_back(std::move(step));
  done_.pop_back();
}

void History::redo() {
  require(!undone_.empty(), "History: there is no step to redo");
  require_own();
  Step& step = undone_.back();
  step.back = step.again();
  done_.push_back(std::move(step));
  undone_.pop_back();
}

void History::undo_to(std::size_t steps) {
  require(steps <= done_.size(), "History: there are fewer than the ", static_cast<long long>(steps),
          " steps to be left");
  while (done_.size() > steps) undo();
}

}  // namespace meshops

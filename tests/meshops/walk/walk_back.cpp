// Steps that undo: with effects as returned, with effects of an earlier state of the mesh, and with invented ones.
#include <algorithm>
#include <cstdint>

#include "meshops/handle/unglue.h"
#include "meshops/stellar/undo.h"
#include "walk/run.h"
#include "walk/walk.h"

namespace meshops::test {

void Walk::take_glue_back() {
  Done<GlueEffect> remembered = recall(glued_);
  GlueEffect& effect = remembered.effect;
  const bool is_made_up = choices_.one_in(2);
  if (is_made_up) {
    Vertex* const vertices[] = {&effect.first_ends.from, &effect.first_ends.to, &effect.second_ends.from,
                                &effect.second_ends.to};
    if (choices_.one_in(3)) effect.survivor = arguments_.halfedge();
    if (choices_.one_in(3)) effect.removed = arguments_.halfedge();
    for (Vertex* const v : vertices)
      if (choices_.one_in(3)) *v = choices_.one_in(2) ? arguments_.vertex() : *vertices[choices_.below(4)];
  }
  judge_.begin("unglue of an effect");
  const Model& before = judge_.before();
  const int h = effect.survivor.idx();
  /// Returns the vertex that was merged into one of two; -1 when they are one; -2 when nothing fits.
  const auto gone_at = [&](int at, Vertex a, Vertex b) {
    if (std::min(a.idx(), b.idx()) != at) return -2;
    if (a == b) return before.is_on_boundary(at) ? -2 : -1;
    const int gone = std::max(a.idx(), b.idx());
    return before.is_on_boundary(at) && is_dead(gone, before.has_vertex) ? gone : -2;
  };
  const auto reason = [&]() -> std::string {
    if (!before.has_side(h) || before.is_boundary(h) || before.is_boundary(h ^ 1)) return "no inner edge";
    const int start = before.to(h ^ 1), end = before.to(h), removed = effect.removed.idx();
    if (before.has_several_fans(start) || before.has_several_fans(end)) return "several fans";
    if (before.has_side(removed) || removed < 0 || static_cast<std::size_t>(removed) >= before.from.size())
      return "nothing to bring back";
    const int at_start = gone_at(start, effect.first_ends.from, effect.second_ends.to);
    const int at_end = gone_at(end, effect.first_ends.to, effect.second_ends.from);
    return at_start == -2 || at_end == -2 || (at_start == at_end && at_start >= 0) ? "other ends" : "";
  }();
  const bool is_fresh = !is_made_up && judge_.records() == remembered.after;
  if (is_fresh && on_ == On::manifolds && !reason.empty()) judge_.fail("cannot be undone at once: " + reason);
  const bool done = judge_.compare_back(
      reason, [&] { meshops::unglue(mesh_, effect); },
      [&](Model& model) { return by_definition::glue(model, h, effect.removed.idx()); });
  if (done && is_fresh && snapshot(mesh_) != remembered.before) judge_.fail("does not restore every record");
}

void Walk::take_weld_back() {
  Done<WeldEffect> remembered = recall(welded_);
  WeldEffect& effect = remembered.effect;
  const bool is_made_up = choices_.one_in(2);
  if (is_made_up) {
    StarElements& removed = effect.removed;
    const auto other = recall(welded_).effect;
    if (choices_.one_in(4)) removed.vertex = choices_.one_in(2) ? other.removed.vertex : arguments_.vertex();
    if (choices_.one_in(4)) removed.edge[choices_.below(3)] = other.removed.edge[choices_.below(3)];
    if (choices_.one_in(8)) removed.edge[choices_.below(3)] = arguments_.edge();
    if (choices_.one_in(4)) removed.face[choices_.below(2)] = other.removed.face[choices_.below(2)];
    if (choices_.one_in(8)) removed.face[choices_.below(2)] = arguments_.face();
    if (choices_.one_in(4)) removed.at_boundary = !removed.at_boundary;
    if (choices_.one_in(3)) effect.left = arguments_.halfedge();
    if (choices_.one_in(3)) effect.right = arguments_.around(effect.left.value_or(Halfedge()));
    if (choices_.one_in(6)) (choices_.one_in(2) ? effect.left : effect.right).reset();
    if (const auto& at = effect.left ? effect.left : effect.right; at && is_live(mesh_, *at) && !choices_.one_in(4))
      effect.survivor = mesh_.from_vertex_handle(*at);
    for (Halfedge& h : effect.named)
      if (choices_.one_in(2)) h = arguments_.halfedge();
    effect.halfedge = Halfedge(static_cast<int>(2U * static_cast<unsigned>(removed.edge[0].idx()) + choices_.below(2)));
    if (choices_.one_in(8)) effect.halfedge = arguments_.halfedge();
  }
  judge_.begin("undo of a weld");
  const Model& before = judge_.before();
  const Run run(mesh_, effect.left, effect.right);
  const auto reason = [&]() -> std::string {
    std::vector<std::int64_t> names;
    bool dead = is_dead(effect.removed.vertex.idx(), before.has_vertex);
    for (const Edge e : effect.removed.edges()) {
      dead =
          dead && e.idx() >= 0 && static_cast<std::size_t>(e.idx()) < mesh_.n_edges() && !before.has_side(2 * e.idx());
      names.push_back(2 * std::int64_t{e.idx()});
    }
    for (const Face f : effect.removed.faces()) {
      dead = dead && f.idx() >= 0 && static_cast<std::size_t>(f.idx()) < mesh_.n_faces() && !before.has_face(f.idx());
      names.push_back(2 * std::int64_t{f.idx()} + 1);
    }
    if (!dead) return "nothing to bring back";
    std::sort(names.begin(), names.end());
    if (std::adjacent_find(names.begin(), names.end()) != names.end()) return "an element twice";
    if (effect.halfedge.idx() >> 1 != effect.removed.edge[0].idx()) return "another halfedge";
    if (effect.removed.at_boundary != (!effect.left || !effect.right)) return "sides that do not fit";
    if (!run.reason.empty()) return run.reason;
    if (judge_.needs_one_fan({.one_fan = run.one_fan})) return "several fans";
    return mesh_.from_vertex_handle(effect.left ? *effect.left : *effect.right) == effect.survivor ? ""
                                                                                                   : "another vertex";
  }();
  const bool is_fresh = !is_made_up && judge_.records() == remembered.after;
  if (is_fresh && on_ == On::manifolds && !reason.empty()) judge_.fail("cannot be undone at once: " + reason);
  const bool done = judge_.compare_back(
      reason, [&] { undo(mesh_, effect); },
      [&](Model& model) { return by_definition::collapse(model, effect.halfedge.idx()); });
  if (done && is_fresh && snapshot(mesh_) != remembered.before) judge_.fail("does not restore every record");
}

void Walk::take_flip_back() {
  Done<FlipEffect> remembered = recall(flipped_);
  FlipEffect& effect = remembered.effect;
  const bool is_made_up = choices_.one_in(2);
  if (is_made_up) {
    if (choices_.one_in(2)) effect.edge = arguments_.edge();
    for (Halfedge& h : effect.named)
      if (choices_.one_in(2)) h = arguments_.halfedge();
  }
  judge_.begin("undo of a flip");
  Model expected = judge_.before();
  std::string reason = by_definition::flip(expected, effect.edge.idx(), true);
  if (reason.empty()) reason = expected.broken();
  const bool is_fresh = !is_made_up && judge_.records() == remembered.after;
  if (is_fresh && !reason.empty()) judge_.fail("cannot be undone at once: " + reason);
  const bool done = judge_.compare_back(
      reason, [&] { undo(mesh_, effect); },
      [&](Model& model) { return by_definition::flip(model, effect.edge.idx()); });
  if (done && is_fresh && snapshot(mesh_) != remembered.before) judge_.fail("does not restore every record");
}

}  // namespace meshops::test

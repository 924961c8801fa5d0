// The steps of the stellar operators.
#include <algorithm>
#include <cstdint>

#include "meshops/stellar/collapse.h"
#include "meshops/stellar/remove_vertex.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/undo.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"
#include "walk/walk.h"

namespace meshops::test {
namespace {

Halfedge ccw(const Connectivity& mesh, Halfedge h) {
  return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
}

/// The names of what a split added; of a split that was refused, any.
Names names_of(const Model& model, const Connectivity& mesh, const std::optional<SplitEffect>& effect) {
  if (!effect) return Names(model);
  std::vector<int> sides, faces;
  const StarElements& added = effect->added;
  for (const Edge e : added.edges()) {
    const Halfedge h = mesh.halfedge_handle(e, 0);
    sides.push_back((mesh.from_vertex_handle(h) == added.vertex ? h : mesh.opposite_halfedge_handle(h)).idx());
  }
  for (const Face f : added.faces()) faces.push_back(f.idx());
  return Names(model, {added.vertex.idx()}, sides, faces);
}

template <typename Effect>
std::optional<Delta> delta_of(const std::optional<Effect>& effect) {
  return effect ? std::optional(effect->delta()) : std::nullopt;
}

/// What a split of a vertex is to be given, seen on the ring of the vertex.
struct Run {
  std::string reason;      ///< why there is none
  std::vector<int> sides;  ///< from left to right
  std::vector<int> one_fan;

  Run(const TestMesh& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right) {
    for (const auto& h : {left, right})
      if (h && !is_live(mesh, *h)) reason = "no such side";
    if (!left && !right) reason = "nothing given";
    if (!reason.empty()) return;
    const Vertex w = mesh.from_vertex_handle(left ? *left : *right);
    if (right && mesh.from_vertex_handle(*right) != w) reason = "two vertices";
    if ((!left || !right) && !mesh.is_boundary(w)) reason = "no boundary";
    if (!reason.empty()) return;
    const Halfedge named = mesh.halfedge_handle(w);
    // A gap lies after each boundary side of the turn. Where one is left out, the gap after the named side is the end.
    int gaps_within = left && mesh.is_boundary(*left) && (right || *left != named) ? 1 : 0, gaps = 0;
    const Halfedge first = ccw(mesh, left ? *left : named), end = right ? *right : ccw(mesh, named);
    for (Halfedge h = first; h != end; h = ccw(mesh, h)) {
      sides.push_back(h.idx());
      gaps_within += mesh.is_boundary(h) && (right || h != named);
    }
    Halfedge h = named;
    do {
      gaps += mesh.is_boundary(h);
      h = ccw(mesh, h);
    } while (h != named);
    if (gaps_within > 0 && gaps > 1) one_fan = {w.idx()};
  }
};

struct Stop {};
constexpr auto stop = [](auto&, const auto&) { throw Stop(); };

/// A split whose hook throws, or which is refused, leaves every record.
template <typename Split>
void check_stopped(const Judge& judge, const TestMesh& mesh, Split split) {
  try {
    split();
    judge.fail("swallowed what its hook threw");
  } catch (const Stop&) {
  } catch (const ContractViolation&) {
  }
  if (snapshot(mesh) != judge.records()) judge.fail("stopped by its hook, did not restore every record");
}

}  // namespace

void Walk::split_edge() {
  const Halfedge h = arguments_.halfedge();
  const Keep keep = arguments_.keep();
  judge_.begin("split_edge");
  if (choices_.one_in(8)) check_stopped(judge_, mesh_, [&] { meshops::split_edge(mesh_, h, stop, keep); });
  const std::optional<SplitEffect> effect =
      judge_.run(split_edge_blocker(mesh_, h, keep), [&] { return meshops::split_edge(mesh_, h, keep); });
  judge_.compare(
      delta_of(effect), {.keep = keep, .touched = {Names::fresh_vertex(judge_.before())}},
      [&](Model& model) { return by_definition::split_edge(model, h.idx(), names_of(model, mesh_, effect)); });
}

void Walk::split_face() {
  const Face f = arguments_.face();
  const int named = is_live(mesh_, f) ? mesh_.halfedge_handle(f).idx() : -1;
  judge_.begin("split_face");
  if (choices_.one_in(8)) check_stopped(judge_, mesh_, [&] { meshops::split_face(mesh_, f, stop); });
  const std::optional<SplitEffect> effect =
      judge_.run(split_face_blocker(mesh_, f), [&] { return meshops::split_face(mesh_, f); });
  judge_.compare(delta_of(effect), {.keep = Keep::simplicial}, [&](Model& model) {
    return by_definition::split_face(model, f.idx(), named, names_of(model, mesh_, effect));
  });
}

void Walk::split_vertex() {
  std::optional<Halfedge> left = choices_.one_in(3) ? arguments_.boundary() : arguments_.halfedge();
  std::optional<Halfedge> right = arguments_.around(*left);
  if (choices_.one_in(4)) left.reset();
  if (choices_.one_in(4)) right.reset();
  const Keep keep = arguments_.keep();
  const Run run(mesh_, left, right);
  judge_.begin("split_vertex");
  if (choices_.one_in(8)) check_stopped(judge_, mesh_, [&] { meshops::split_vertex(mesh_, left, right, stop, keep); });
  const std::optional<SplitEffect> effect = judge_.run(split_vertex_blocker(mesh_, left, right, keep),
                                                       [&] { return meshops::split_vertex(mesh_, left, right, keep); });
  judge_.compare(delta_of(effect),
                 {.keep = keep, .one_fan = run.one_fan, .touched = {Names::fresh_vertex(judge_.before())}},
                 [&](Model& model) {
                   if (!run.reason.empty()) return run.reason;
                   return by_definition::split_vertex(model, left ? left->idx() : -1, right ? right->idx() : -1,
                                                      run.sides, names_of(model, mesh_, effect));
                 });
}

void Walk::flip() {
  const Edge e = arguments_.edge();
  const Keep keep = arguments_.keep();
  std::vector<int> apexes;
  if (is_live(mesh_, e))
    for (const unsigned side : {0U, 1U})
      apexes.push_back(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(mesh_.halfedge_handle(e, side))).idx());
  judge_.begin("flip");
  const auto effect = judge_.run(flip_blocker(mesh_, e, keep), [&] { return meshops::flip(mesh_, e, keep); });
  judge_.compare(delta_of(effect), {.keep = keep, .touched = apexes},
                 [&](Model& model) { return by_definition::flip(model, e.idx()); });
  if (effect) remember(flipped_, *effect);
}

void Walk::collapse() {
  const Halfedge h = arguments_.halfedge();
  const Keep keep = arguments_.keep();
  const std::vector<int> at = ends(h);
  judge_.begin("collapse");
  const auto effect = judge_.run(collapse_blocker(mesh_, h, keep), [&] { return meshops::collapse(mesh_, h, keep); });
  Rules rules{.keep = keep};
  if (!at.empty()) rules.one_fan = {at[0]}, rules.touched = {at[1]};
  judge_.compare(delta_of(effect), rules, [&](Model& model) { return by_definition::collapse(model, h.idx()); });
  if (effect) remember(welded_, *effect);
}

void Walk::weld_edge() {
  Halfedge h = arguments_.halfedge();
  if (const Vertex v = arguments_.vertex(choices_.one_in(3) ? 3 : 4); is_live(mesh_, v))
    h = arguments_.around(mesh_.halfedge_handle(v));
  const Keep keep = arguments_.keep();
  const std::vector<int> at = ends(h);
  judge_.begin("weld_edge");
  const auto effect = judge_.run(weld_edge_blocker(mesh_, h, keep), [&] { return meshops::weld_edge(mesh_, h, keep); });
  Rules rules{.keep = keep};
  if (!at.empty()) rules.one_fan = {at[0]}, rules.touched = {at[1]};
  judge_.compare(delta_of(effect), rules, [&](Model& model) { return by_definition::weld_edge(model, h.idx()); });
  if (!effect) return;
  const Halfedge line = effect->line;
  if (!is_live(mesh_, line) || mesh_.to_vertex_handle(line) != effect->survivor ||
      judge_.before().to(line.idx()) != at[0])
    judge_.fail("told a wrong line");
  remember(welded_, static_cast<const WeldEffect&>(*effect));
}

void Walk::weld_face() {
  const Vertex v = arguments_.vertex(3);
  const Keep keep = arguments_.keep();
  const Halfedge named = is_live(mesh_, v) ? mesh_.halfedge_handle(v) : Halfedge();
  Rules rules{.keep = keep};
  if (named.is_valid()) rules.touched = {mesh_.to_vertex_handle(named).idx()};
  judge_.begin("weld_face");
  const auto effect = judge_.run(weld_face_blocker(mesh_, v, keep), [&] { return meshops::weld_face(mesh_, v, keep); });
  judge_.compare(delta_of(effect), rules,
                 [&](Model& model) { return by_definition::weld_face(model, v.idx(), named.idx()); });
  if (!effect) return;
  if (!is_live(mesh_, effect->face)) judge_.fail("told a wrong face");
  remember(welded_, static_cast<const WeldEffect&>(*effect));
}

void Walk::remove_vertex() {
  const Vertex v = arguments_.vertex();
  const Keep keep = arguments_.keep();
  std::vector<Halfedge> tried;  // those before the first that can be collapsed
  bool can = false;
  if (is_live(mesh_, v) && !mesh_.is_isolated(v)) {
    Halfedge h = mesh_.halfedge_handle(v);
    do {
      can = !collapse_blocker(mesh_, h, keep);
      tried.push_back(h);
      h = mesh_.next_halfedge_handle(mesh_.opposite_halfedge_handle(h));
    } while (!can && h != tried.front());
  }
  judge_.begin("remove_vertex");
  const auto effect =
      judge_.run(remove_vertex_blocker(mesh_, v, keep), [&] { return meshops::remove_vertex(mesh_, v, keep); });
  judge_.compare(delta_of(effect), {.keep = keep}, [&](Model& model) -> std::string {
    if (!can) return "no neighbour takes over";
    if (effect && effect->halfedge != tried.back()) return "another neighbour comes first";
    return by_definition::collapse(model, tried.back().idx());
  });
  if (effect) remember(welded_, *effect);
}

void Walk::take_weld_back() {
  auto [effect, records_before, records_after] = recall(welded_);
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
  const bool is_fresh = !is_made_up && judge_.records() == records_after;
  if (is_fresh && on_ == On::manifolds && !reason.empty()) judge_.fail("cannot be done at once: " + reason);
  const bool done = judge_.compare_back(
      reason, [&] { undo(mesh_, effect); },
      [&](Model& model) { return by_definition::collapse(model, effect.halfedge.idx()); });
  if (done && is_fresh && snapshot(mesh_) != records_before) judge_.fail("does not restore every record");
}

void Walk::take_flip_back() {
  auto [effect, records_before, records_after] = recall(flipped_);
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
  const bool is_fresh = !is_made_up && judge_.records() == records_after;
  if (is_fresh && !reason.empty()) judge_.fail("cannot be done at once: " + reason);
  const bool done = judge_.compare_back(
      reason, [&] { undo(mesh_, effect); },
      [&](Model& model) { return by_definition::flip(model, effect.edge.idx()); });
  if (done && is_fresh && snapshot(mesh_) != records_before) judge_.fail("does not restore every record");
}

}  // namespace meshops::test

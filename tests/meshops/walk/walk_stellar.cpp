// The steps of the stellar operators.

#include "meshops/stellar/collapse.h"
#include "meshops/stellar/remove_vertex.h"
#include "meshops/stellar/split_edge.h"
#include "meshops/stellar/split_face.h"
#include "meshops/stellar/split_vertex.h"
#include "meshops/stellar/weld_edge.h"
#include "meshops/stellar/weld_face.h"
#include "walk/run.h"
#include "walk/walk.h"

namespace meshops::test {
namespace {

/// Returns the names of the elements that a split added; for a refused split, any names.
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

struct Stop {};
constexpr auto stop = [](auto&, const auto&) { throw Stop(); };

/// Checks that a split whose hook throws, or that is refused, leaves every record.
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
    judge_.fail("returned a wrong line");
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
  if (!is_live(mesh_, effect->face)) judge_.fail("returned a wrong face");
  remember(welded_, static_cast<const WeldEffect&>(*effect));
}

void Walk::remove_vertex() {
  const Vertex v = arguments_.vertex();
  const Keep keep = arguments_.keep();
  std::vector<Halfedge> tried;  // halfedges before the first that can be collapsed
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
    if (!can) return "no neighbor takes over";
    if (effect && effect->halfedge != tried.back()) return "another neighbor comes first";
    return by_definition::collapse(model, tried.back().idx());
  });
  if (effect) remember(welded_, *effect);
}

}  // namespace meshops::test

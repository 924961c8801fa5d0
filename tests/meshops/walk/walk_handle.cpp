// The steps of the handle operators.

#include "meshops/handle/close_curve.h"
#include "meshops/handle/create.h"
#include "meshops/handle/destroy.h"
#include "meshops/handle/separate_fans.h"
#include "meshops/handle/unglue.h"
#include "meshops/handle/zip_curves.h"
#include "walk/walk.h"

namespace meshops::test {
namespace {

std::vector<int> joined(std::vector<int> a, const std::vector<int>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

void Walk::create() {
  judge_.begin("create_triangle");
  const auto effect = judge_.run(std::nullopt, [&] { return create_triangle(mesh_); });
  judge_.compare(delta_of_create(), {}, [&](Model& model) {
    Cycle cycle;
    Halfedge h = effect->inner;
    for (int i = 0; i < 3; ++i, h = mesh_.next_halfedge_handle(h)) cycle.push_back(h.idx());
    for (const int s : cycle) {
      const Halfedge at(s);
      if (model.has_side(s)) return "an edge that was there already";
      if (is_dead(mesh_.from_vertex_handle(at).idx(), model.has_vertex)) return "a vertex that was there already";
      model.add_vertex(mesh_.from_vertex_handle(at).idx());
      model.add_edge(s, mesh_.from_vertex_handle(at).idx(), mesh_.to_vertex_handle(at).idx());
    }
    model.set_face(effect->face.idx(), cycle);
    return "";
  });
}

void Walk::destroy() {
  Face f = arguments_.face();
  if (const Halfedge h = arguments_.boundary(); choices_.one_in(2) && is_live(mesh_, h))
    f = mesh_.face_handle(mesh_.opposite_halfedge_handle(h));
  judge_.begin("destroy_triangle");
  const auto delta = judge_.run(destroy_triangle_blocker(mesh_, f), [&] { return destroy_triangle(mesh_, f); });
  judge_.compare(delta, {.one_fan = delta ? std::vector<int>() : corners(f)},
                 [&](Model& model) { return by_definition::destroy_triangle(model, f.idx()); });
}

void Walk::remove() {
  const Face f = arguments_.face();
  const std::vector<int> at = corners(f);
  judge_.begin("remove_triangle");
  const auto delta = judge_.run(remove_triangle_blocker(mesh_, f), [&] { return remove_triangle(mesh_, f); });
  const Model left(mesh_);
  judge_.compare(delta, {.one_fan = at},
                 [&](Model& model) { return by_definition::remove_triangle(model, f.idx(), delta ? &left : nullptr); });
}

void Walk::glue() {
  const Halfedge first = arguments_.boundary(), second = arguments_.boundary_near(first);
  const std::vector<int> at = joined(ends(first), ends(second));
  judge_.begin("glue");
  const auto blocker = glue_blocker(mesh_, first, second);
  const auto what = blocker ? GlueCase::join : glue_case(mesh_, first, second);
  const bool is_known = choices_.one_in(2);
  const auto effect = judge_.run(blocker, [&] {
    return is_known ? meshops::glue(mesh_, first, second, what) : meshops::glue(mesh_, first, second);
  });
  judge_.compare(effect ? std::optional(effect->delta()) : std::nullopt, {.one_fan = at},
                 [&](Model& model) { return by_definition::glue(model, first.idx(), second.idx()); });
  if (!effect) return;
  if (effect->survivor != first || effect->removed != second) judge_.fail("returned wrong halfedges");
  remember(glued_, *effect);
}

void Walk::unglue() {
  const Halfedge h = arguments_.halfedge();
  const std::vector<int> at = ends(h);
  judge_.begin("unglue");
  const auto blocker = unglue_blocker(mesh_, h);
  const auto what = blocker ? GlueCase::join : unglue_case(mesh_, h);
  const auto effect = judge_.run(blocker, [&] { return meshops::unglue(mesh_, h); });
  judge_.compare(effect ? std::optional(effect->delta()) : std::nullopt, {.one_fan = at}, [&](Model& model) {
    if (!effect) return by_definition::unglue(model, h.idx(), Names(model));
    std::vector<int> copies;
    for (const Vertex v : {effect->new_start, effect->new_end})
      if (v.is_valid()) copies.push_back(v.idx());
    return by_definition::unglue(model, h.idx(), Names(model, copies, {effect->second.idx()}));
  });
  if (effect && (effect->what != what || effect->first != h)) judge_.fail("returned another case");
}

void Walk::close() {
  const Halfedge h = arguments_.boundary();
  const std::vector<int> at = on_curve(h);
  judge_.begin("close_curve");
  const auto effect = judge_.run(close_curve_blocker(mesh_, h), [&] { return close_curve(mesh_, h); });
  judge_.compare(effect ? std::optional(effect->delta()) : std::nullopt, {.one_fan = at}, [&](Model& model) {
    return by_definition::close_curve(model, h.idx(),
                                      effect ? Names(model, {}, {}, {effect->face.idx()}) : Names(model));
  });
}

void Walk::open() {
  const Face f = arguments_.face();
  judge_.begin("open_curve");
  const auto effect = judge_.run(open_curve_blocker(mesh_, f), [&] { return open_curve(mesh_, f); });
  judge_.compare(effect ? std::optional(effect->delta()) : std::nullopt, {},
                 [&](Model& model) { return by_definition::open_curve(model, f.idx()); });
}

void Walk::zip() {
  const Halfedge first = arguments_.boundary(), second = arguments_.boundary();
  const std::vector<int> at = joined(on_curve(first), on_curve(second));
  judge_.begin("zip_curves");
  const auto effect =
      judge_.run(zip_curves_blocker(mesh_, first, second), [&] { return zip_curves(mesh_, first, second); });
  judge_.compare(effect ? std::optional(effect->delta()) : std::nullopt, {.one_fan = at},
                 [&](Model& model) { return by_definition::zip_curves(model, first.idx(), second.idx()); });
  if (!effect || !choices_.one_in(2)) return;
  undo(mesh_, *effect);
  if (snapshot(mesh_) != judge_.records()) judge_.fail("is not restored by undo()");
}

void Walk::separate() {
  judge_.begin("separate_fans");
  const int further = judge_.before().excess_fans();
  const auto copied = judge_.run(std::nullopt, [&] { return separate_fans(mesh_); });
  const Model left(mesh_);
  if (copied->size() != static_cast<std::size_t>(further)) judge_.fail("made another number of vertices");
  if (further == 0 && snapshot(mesh_) != judge_.records()) judge_.fail("touched a sound mesh");
  if (left.excess_fans() != 0 || !left.broken().empty() || left.faces != judge_.before().faces)
    judge_.fail("left something else");
  for (const Defect& defect : validate(mesh_)) judge_.fail("left " + describe(defect));
}

}  // namespace meshops::test

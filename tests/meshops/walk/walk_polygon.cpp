// The steps that cut and merge faces.
#include <algorithm>

#include "meshops/stellar/diagonal.h"
#include "meshops/stellar/triangulate_face.h"
#include "walk/walk.h"

namespace meshops::test {
namespace {

/// Returns whether the part of a face between two corners has a triangulation, by trying all; for a face of up to nine
/// sides.
bool has_triangulation(const Model& model, const Cycle& sides, std::size_t first, std::size_t last, Keep keep) {
  const auto may_join = [&](std::size_t i, std::size_t j) {
    if (j == i + 1 || (i == 0 && j + 1 == sides.size())) return true;
    const int a = model.to(sides[i] ^ 1), b = model.to(sides[j] ^ 1);
    if (a == b) return false;
    if (keep == Keep::manifold) return true;
    const std::vector<int> out = model.leaving(a);
    return std::none_of(out.begin(), out.end(), [&](int h) { return model.to(h) == b; });
  };
  if (last == first + 1) return true;
  if (!may_join(first, last)) return false;
  for (std::size_t m = first + 1; m < last; ++m)
    if (has_triangulation(model, sides, first, m, keep) && has_triangulation(model, sides, m, last, keep)) return true;
  return false;
}

}  // namespace

void Walk::insert_diagonal() {
  Halfedge from = arguments_.halfedge(), to = arguments_.halfedge();
  if (const Face f = arguments_.polygon(); is_live(mesh_, f) && !choices_.one_in(4)) from = mesh_.halfedge_handle(f);
  if (is_live(mesh_, from) && !choices_.one_in(6)) {
    to = from;
    for (unsigned steps = choices_.below(6); steps > 0; --steps) to = mesh_.next_halfedge_handle(to);
  }
  const Keep keep = arguments_.keep();
  int named = -1;
  std::vector<int> corners;
  if (is_live(mesh_, from) && !mesh_.is_boundary(from)) {
    named = mesh_.halfedge_handle(mesh_.face_handle(from)).idx();
    corners = {mesh_.from_vertex_handle(from).idx()};
  }
  judge_.begin("insert_diagonal");
  const auto effect = judge_.run(insert_diagonal_blocker(mesh_, from, to, keep),
                                 [&] { return meshops::insert_diagonal(mesh_, from, to, keep); });
  judge_.compare(effect ? std::optional(effect->delta()) : std::nullopt, {.keep = keep, .touched = corners},
                 [&](Model& model) {
                   Names names(model);
                   if (effect) {
                     Halfedge h = effect->diagonal;
                     if (mesh_.from_vertex_handle(h) != mesh_.from_vertex_handle(from))
                       h = mesh_.opposite_halfedge_handle(h);
                     names = Names(model, {}, {h.idx()}, {effect->face.idx()});
                   }
                   return by_definition::insert_diagonal(model, from.idx(), to.idx(), named, names);
                 });
  if (effect && mesh_.face_handle(effect->diagonal) != effect->face) judge_.fail("returned a wrong halfedge");
}

void Walk::remove_diagonal() {
  const Halfedge h = arguments_.halfedge();
  judge_.begin("remove_diagonal");
  const auto effect = judge_.run(remove_diagonal_blocker(mesh_, h), [&] { return meshops::remove_diagonal(mesh_, h); });
  judge_.compare(effect ? std::optional(effect->delta()) : std::nullopt, {},
                 [&](Model& model) { return by_definition::remove_diagonal(model, h.idx()); });
  if (!effect) return;
  Model again(mesh_);
  if (!by_definition::insert_diagonal(again, effect->from.idx(), effect->to.idx(), effect->to.idx(), Names(again))
           .empty())
    judge_.fail("returned wrong halfedges");
}

void Walk::triangulate_face() {
  const Face f = arguments_.polygon();
  const Keep keep = arguments_.keep();
  const unsigned weights = choices_.below(256);
  const auto weight = [&](Vertex a, Vertex b, Vertex c) {
    return (static_cast<unsigned>(a.idx() + 3 * b.idx() + 7 * c.idx()) ^ weights) % 17;
  };
  judge_.begin("triangulate_face");
  const auto effect = judge_.run(triangulate_face_blocker(mesh_, f, keep),
                                 [&] { return meshops::triangulate_face(mesh_, f, weight, keep); });
  if (!effect) {
    judge_.compare(std::nullopt, {}, [&](Model& model) -> std::string {
      if (!model.has_face(f.idx())) return "no such face";
      std::vector<int> corners = this->corners(f);
      const Cycle sides = model.cycle(f.idx(), mesh_.halfedge_handle(f).idx());
      std::sort(corners.begin(), corners.end());
      if (keep == Keep::simplicial && std::adjacent_find(corners.begin(), corners.end()) != corners.end())
        return "passes a vertex twice";
      if (sides.size() > 9) return "not looked at";
      return has_triangulation(model, sides, 0, sides.size() - 1, keep) ? "" : "no triangulation";
    });
    return;
  }
  // Removing the diagonals from the last to the first restores the face.
  judge_.compare_back(
      "", [] {},
      [&](Model& model) -> std::string {
        if (model.doubled() > judge_.before().doubled() && keep == Keep::simplicial) return "not simplicial";
        for (std::size_t i = effect->diagonals.size(); i-- > 0;) {
          const int h = effect->diagonals[i].idx();
          if (model.face_of(h) != effect->faces[i].idx()) return "a wrong face";
          if (model.faces[static_cast<std::size_t>(effect->faces[i].idx())].size() < 3) return "no face";
          if (const std::string bad = by_definition::remove_diagonal(model, h); !bad.empty()) return bad;
        }
        return "";
      });
  for (const Face part : effect->faces)
    if (mesh_.valence(part) != 3) judge_.fail("left a polygon");
  if (mesh_.valence(f) != 3) judge_.fail("left a polygon");
}

}  // namespace meshops::test

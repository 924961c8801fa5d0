#include "meshops/handle/zip_curves.h"

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/core/reach.h"
#include "meshops/handle/unchecked.h"

namespace meshops {
namespace {

std::size_t length_of_curve(const Connectivity& mesh, Halfedge through) {
  std::size_t edges = 0;
  Halfedge h = through;
  do {
    ++edges;
    h = mesh.next_halfedge_handle(h);
  } while (h != through);
  return edges;
}

}  // namespace

std::optional<Blocker> zip_curves_blocker(const Connectivity& mesh, Halfedge first, Halfedge second) {
  if (const auto reason = detail::status_blocker(mesh)) return reason;
  if (const auto reason = detail::boundary_blocker(mesh, first, second)) return reason;
  if (on_same_curve(mesh, first, second)) return Blocker(BlockerKind::same_curve, second);
  if (const std::size_t edges = length_of_curve(mesh, second); edges != length_of_curve(mesh, first))
    return Blocker(BlockerKind::curve_length, second, static_cast<int>(edges));
  // Each vertex of one curve merges with one vertex of the other, so that a check of every pair beforehand is complete.
  Halfedge h = first, g = second;
  do {
    if (const auto reason = detail::merge_blocker(mesh, h, mesh.next_halfedge_handle(g))) return reason;
    h = mesh.next_halfedge_handle(h);
    g = mesh.prev_halfedge_handle(g);
  } while (h != first);
  return std::nullopt;
}

ZipCurvesEffect zip_curves(Connectivity& mesh, Halfedge first, Halfedge second) {
  detail::enforce("zip_curves", zip_curves_blocker(mesh, first, second));
  const std::size_t edges = length_of_curve(mesh, first);
  ZipCurvesEffect effect;
  effect.glued.reserve(edges);
  Halfedge h = first, g = second;
  for (std::size_t i = 0; i < edges; ++i) {
    const Halfedge next = mesh.next_halfedge_handle(h), previous = mesh.prev_halfedge_handle(g);
    const GlueCase what = i == 0 ? detail::case_of_glue(mesh, h, g) : i + 1 < edges ? GlueCase::zip : GlueCase::close;
    effect.glued.push_back(detail::glue_links(mesh, h, g, what));
    h = next;
    g = previous;
  }
  return effect;
}

void undo(Connectivity& mesh, const ZipCurvesEffect& effect) {
  for (std::size_t i = effect.glued.size(); i-- > 0;) unglue(mesh, effect.glued[i]);
}

}  // namespace meshops

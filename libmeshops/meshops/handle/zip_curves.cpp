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

std::optional<std::string> zip_curves_blocker(const Connectivity& mesh, Halfedge first, Halfedge second) {
  if (const char* reason = detail::status_refusal(mesh)) return reason;
  if (!is_live(mesh, first) || !is_live(mesh, second)) return "a halfedge does not exist or is deleted";
  if (!mesh.is_boundary(first) || !mesh.is_boundary(second)) return "a halfedge is not on the boundary";
  if (on_same_curve(mesh, first, second)) return "both halfedges are on one curve";
  if (const std::size_t a = length_of_curve(mesh, first), b = length_of_curve(mesh, second); a != b)
    return "the curves have " + std::to_string(a) + " and " + std::to_string(b) + " edges";
  // Each vertex of one curve merges with one vertex of the other, so that checking every pair beforehand covers all.
  Halfedge h = first, g = second;
  do {
    if (const char* reason = detail::merge_refusal(mesh, h, mesh.next_halfedge_handle(g))) return reason;
    h = mesh.next_halfedge_handle(h);
    g = mesh.prev_halfedge_handle(g);
  } while (h != first);
  return std::nullopt;
}

ZipCurvesEffect zip_curves(Connectivity& mesh, Halfedge first, Halfedge second) {
  if (const auto blocker = zip_curves_blocker(mesh, first, second)) throw ContractViolation("zip_curves: " + *blocker);
  const std::size_t edges = length_of_curve(mesh, first);
  ZipCurvesEffect effect{GlueCase::join, edges};
  Halfedge h = first, g = second;
  for (std::size_t i = 0; i < edges; ++i) {
    const Halfedge next = mesh.next_halfedge_handle(h), previous = mesh.prev_halfedge_handle(g);
    const GlueCase what = i == 0 ? detail::case_of_glue(mesh, h, g) : i + 1 < edges ? GlueCase::zip : GlueCase::close;
    if (i == 0) effect.begins_with = what;
    detail::glue_links(mesh, h, g, what);
    h = next;
    g = previous;
  }
  return effect;
}

}  // namespace meshops

#include "meshops/stellar/undo.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

template <typename Element>
bool is_marked(const Connectivity& mesh, std::size_t count, Element element) {
  return element.idx() >= 0 && static_cast<std::size_t>(element.idx()) < count && mesh.status(element).deleted();
}

const char* refusal(const Connectivity& mesh, const WeldEffect& effect) {
  const StarElements& removed = effect.removed;
  const auto edges = removed.edges();
  const auto faces = removed.faces();
  bool marked = is_marked(mesh, mesh.n_vertices(), removed.vertex);
  for (const Edge e : edges) marked = marked && is_marked(mesh, mesh.n_edges(), e);
  for (const Face f : faces) marked = marked && is_marked(mesh, mesh.n_faces(), f);
  if (!marked) return "the elements to restore do not exist or are not marked deleted";
  const bool differ = edges[0] != edges[1] && edges.back() != edges[0] && (edges.size() == 2 || edges[1] != edges[2]) &&
                      (faces.size() == 1 || faces[0] != faces[1]);
  const bool one_is_left_out = !effect.left || !effect.right;
  if (!differ || mesh.edge_handle(effect.halfedge) != edges[0] || one_is_left_out != removed.at_boundary)
    return "the edges, faces and halfedges of the effect contradict each other (pass the effect unchanged)";
  if (const char* reason = detail::open_refusal(mesh, effect.left, effect.right, Keep::manifold)) return reason;
  return mesh.from_vertex_handle(effect.left ? *effect.left : *effect.right) == effect.survivor
             ? nullptr
             : "the halfedges of the effect no longer leave the surviving vertex";
}

}  // namespace

void undo(Connectivity& mesh, const WeldEffect& effect) {
  detail::require_status(mesh, "undo");
  detail::enforce("undo", refusal(mesh, effect));
  detail::open_vertex_again(mesh, effect);
}

}  // namespace meshops

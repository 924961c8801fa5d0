#include "meshops/stellar/undo.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

template <typename Element>
bool is_marked(const Connectivity& mesh, std::size_t count, Element element) {
  return element.idx() >= 0 && static_cast<std::size_t>(element.idx()) < count && mesh.status(element).deleted();
}

/// Throws ContractViolation if the effect contradicts itself or the mesh. Returns the result of open_blocker().
std::optional<Blocker> check(const Connectivity& mesh, const WeldEffect& effect) {
  const StarElements& removed = effect.removed;
  const auto edges = removed.edges();
  const auto faces = removed.faces();
  bool marked = is_marked(mesh, mesh.n_vertices(), removed.vertex);
  for (const Edge e : edges) marked = marked && is_marked(mesh, mesh.n_edges(), e);
  for (const Face f : faces) marked = marked && is_marked(mesh, mesh.n_faces(), f);
  require(marked, "undo: the elements to restore do not exist or are not marked deleted");
  const bool differ = edges[0] != edges[1] && edges.back() != edges[0] && (edges.size() == 2 || edges[1] != edges[2]) &&
                      (faces.size() == 1 || faces[0] != faces[1]);
  const bool one_is_left_out = !effect.left || !effect.right;
  require(differ && mesh.edge_handle(effect.halfedge) == edges[0] && one_is_left_out == removed.at_boundary,
          "undo: the edges, faces and halfedges of the effect contradict each other (pass the effect unchanged)");
  if (const auto reason = detail::open_blocker(mesh, effect.left, effect.right, Keep::manifold)) return reason;
  require(mesh.from_vertex_handle(effect.left ? *effect.left : *effect.right) == effect.survivor,
          "undo: the halfedges of the effect no longer leave the surviving vertex");
  return std::nullopt;
}

}  // namespace

void undo(Connectivity& mesh, const WeldEffect& effect) {
  detail::require_status(mesh, "undo");
  detail::enforce("undo", check(mesh, effect));
  detail::open_vertex_again(mesh, effect);
}

}  // namespace meshops

#include "meshops/stellar/split_vertex.h"

#include "meshops/stellar/relink.h"

namespace meshops {
std::optional<Blocker> split_vertex_blocker(const Connectivity& mesh, std::optional<Halfedge> left,
                                            std::optional<Halfedge> right, Keep keep) {
  return detail::open_blocker(mesh, left, right, keep);
}

SplitVertexEffect split_vertex(Connectivity& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right,
                               Keep keep) {
  detail::enforce("split_vertex", detail::open_blocker(mesh, left, right, keep));
  const Vertex w = mesh.from_vertex_handle(left ? *left : *right);
  return {detail::open_vertex(mesh, w, left.value_or(Halfedge()), right.value_or(Halfedge()))};
}

}  // namespace meshops

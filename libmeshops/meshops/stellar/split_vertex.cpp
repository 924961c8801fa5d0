#include "meshops/stellar/split_vertex.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

const char* refusal(const Connectivity& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right, Keep keep) {
  if (!left && !right) return "both halfedges are left out";
  if ((left && !is_live(mesh, *left)) || (right && !is_live(mesh, *right))) return "no such halfedge";
  const Vertex w = mesh.from_vertex_handle(left ? *left : *right);
  if (left && right && mesh.from_vertex_handle(*right) != w) return "the halfedges leave different vertices";
  if ((!left || !right) && !mesh.is_boundary(w)) return "a halfedge is left out and the vertex is not on the boundary";
  return detail::open_refusal(mesh, w, left.value_or(Halfedge()), right.value_or(Halfedge()), keep);
}

}  // namespace

std::optional<std::string> split_vertex_blocker(const Connectivity& mesh, std::optional<Halfedge> left,
                                                std::optional<Halfedge> right, Keep keep) {
  return detail::as_blocker(refusal(mesh, left, right, keep));
}

SplitEffect split_vertex(Connectivity& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right, Keep keep) {
  detail::enforce("split_vertex", refusal(mesh, left, right, keep));
  const Vertex w = mesh.from_vertex_handle(left ? *left : *right);
  return detail::open_vertex(mesh, w, left.value_or(Halfedge()), right.value_or(Halfedge()));
}

}  // namespace meshops

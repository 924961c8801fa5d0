#include "meshops/stellar/split_edge.h"

#include "meshops/stellar/relink.h"

namespace meshops {
namespace {

/// A split of b that gives the new vertex the edge to a, and no other.
struct Place {
  Place(const Connectivity& mesh, Halfedge h) : b(mesh.to_vertex_handle(h)) {
    const Halfedge o = mesh.opposite_halfedge_handle(h);
    if (!mesh.is_boundary(h)) left = mesh.next_halfedge_handle(h);
    if (!mesh.is_boundary(o)) right = detail::ccw(mesh, o);
  }
  Vertex b;
  Halfedge left, right;
};

const char* refusal(const Connectivity& mesh, Halfedge h, Keep keep) {
  if (!is_live(mesh, h)) return "no such edge";
  for (const Halfedge side : {h, mesh.opposite_halfedge_handle(h)})
    if (!mesh.is_boundary(side) && !detail::is_triangle(mesh, side)) return "a face is not a triangle";
  if (keep == Keep::manifold) return nullptr;
  const Place at(mesh, h);
  return detail::open_refusal(mesh, at.b, at.left, at.right, keep);
}

Halfedge first_halfedge(const Connectivity& mesh, Edge e) {
  return is_live(mesh, e) ? mesh.halfedge_handle(e, 0) : Halfedge();
}

}  // namespace

std::optional<std::string> split_edge_blocker(const Connectivity& mesh, Halfedge h, Keep keep) {
  return detail::as_blocker(refusal(mesh, h, keep));
}

std::optional<std::string> split_edge_blocker(const Connectivity& mesh, Edge e, Keep keep) {
  return split_edge_blocker(mesh, first_halfedge(mesh, e), keep);
}

SplitEffect split_edge(Connectivity& mesh, Halfedge h, Keep keep) {
  detail::enforce("split_edge", refusal(mesh, h, keep));
  const Place at(mesh, h);
  return detail::open_vertex(mesh, at.b, at.left, at.right);
}

SplitEffect split_edge(Connectivity& mesh, Edge e, Keep keep) {
  return split_edge(mesh, first_halfedge(mesh, e), keep);
}

}  // namespace meshops

#include "support/bowties.h"

#include <map>

#include "meshops/core/live.h"
#include "meshops/handle/fan.h"

namespace meshops::test {

void tie(Connectivity& mesh, Vertex stays, Vertex goes) {
  const Halfedge out = mesh.halfedge_handle(stays), other_out = mesh.halfedge_handle(goes);
  const Halfedge in = mesh.prev_halfedge_handle(out), other_in = mesh.prev_halfedge_handle(other_out);
  detail::move_fan(mesh, other_out, stays);
  if (mesh.is_boundary(out) && mesh.is_boundary(other_out)) {
    mesh.set_next_halfedge_handle(in, other_out);
    mesh.set_next_halfedge_handle(other_in, out);
  }
  if (mesh.is_boundary(other_out)) mesh.set_halfedge_handle(stays, other_out);
  mesh.set_isolated(goes);
  mesh.status(goes).set_deleted(true);
}

void tie_points(Connectivity& mesh, const std::vector<std::uint32_t>& point_of_vertex) {
  std::map<std::uint32_t, Vertex> first;
  for (std::size_t i = 0; i < point_of_vertex.size(); ++i) {
    const Vertex v(static_cast<int>(i));
    if (const auto [at, is_new] = first.try_emplace(point_of_vertex[i], v); !is_new) tie(mesh, at->second, v);
  }
}

int tie_at_random(Connectivity& mesh, int attempts, std::mt19937& random) {
  int tied = 0;
  for (int i = 0; i < attempts; ++i) {
    const Vertex v(static_cast<int>(random() % mesh.n_vertices())), w(static_cast<int>(random() % mesh.n_vertices()));
    const auto can = [&](Vertex x) { return is_live(mesh, x) && !mesh.is_isolated(x) && mesh.is_boundary(x); };
    if (v == w || !can(v) || !can(w) || mesh.find_halfedge(v, w).is_valid()) continue;
    tie(mesh, v, w);
    ++tied;
  }
  return tied;
}

}  // namespace meshops::test

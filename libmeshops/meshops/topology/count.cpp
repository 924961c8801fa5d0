#include "meshops/topology/count.h"

#include <boost/pending/disjoint_sets.hpp>
#include <vector>

#include "meshops/core/live.h"

namespace meshops {

TopologyCounts count_topology(const Connectivity& mesh) {
  TopologyCounts counts;
  std::vector<std::size_t> parent(mesh.n_vertices());
  std::vector<unsigned char> rank(mesh.n_vertices(), 0);
  boost::disjoint_sets<unsigned char*, std::size_t*> sets(rank.data(), parent.data());
  for (std::size_t i = 0; i < mesh.n_vertices(); ++i) {
    sets.make_set(i);
    const Vertex v(static_cast<int>(i));
    if (!is_live(mesh, v)) continue;
    ++counts.vertices;
    ++counts.components;
    if (mesh.is_isolated(v)) ++counts.isolated;
  }
  for_each_edge(mesh, [&](Edge e) {
    ++counts.edges;
    const Halfedge h = mesh.halfedge_handle(e, 0);
    const std::size_t a = sets.find_set(static_cast<std::size_t>(mesh.from_vertex_handle(h).idx()));
    const std::size_t b = sets.find_set(static_cast<std::size_t>(mesh.to_vertex_handle(h).idx()));
    if (a != b) {
      sets.link(a, b);
      --counts.components;
    }
  });
  for_each_face(mesh, [&](Face) { ++counts.faces; });
  std::vector<bool> on_known_curve(mesh.n_halfedges(), false);
  for_each_halfedge(mesh, [&](Halfedge first) {
    const auto known = [&](Halfedge h) { return on_known_curve[static_cast<std::size_t>(h.idx())]; };
    if (!mesh.is_boundary(first) || known(first)) return;
    ++counts.boundary_curves;
    for (Halfedge h = first; !known(h); h = mesh.next_halfedge_handle(h))
      on_known_curve[static_cast<std::size_t>(h.idx())] = true;
  });
  return counts;
}

}  // namespace meshops

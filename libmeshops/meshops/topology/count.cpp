#include "meshops/topology/count.h"

#include <cstdint>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "meshops/core/live.h"

namespace meshops {

TopologyCounts count_topology(const Connectivity& mesh) {
  TopologyCounts counts;
  DisjointSets components(mesh.n_vertices());
  for (std::size_t i = 0; i < mesh.n_vertices(); ++i) {
    const Vertex v(static_cast<int>(i));
    if (!is_live(mesh, v)) continue;
    ++counts.vertices;
    ++counts.components;
    if (mesh.is_isolated(v)) ++counts.isolated;
  }
  for_each_edge(mesh, [&](Edge e) {
    ++counts.edges;
    const Halfedge h = mesh.halfedge_handle(e, 0);
    counts.components -= components.join(static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx()),
                                         static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx()));
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

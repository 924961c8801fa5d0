#include "rbpa/topology.h"

#include <algorithm>
#include <boost/pending/disjoint_sets.hpp>
#include <vector>

#include "meshops/topology/count.h"

namespace rbpa {

ComplexCounts count(const SolidAlphaComplex& complex) {
  const meshops::TopologyCounts mesh = meshops::count_topology(complex.mesh);
  ComplexCounts counts{.edges = mesh.edges,
                       .triangles = mesh.faces,
                       .boundary_curves = mesh.boundary_curves,
                       .solid_components = mesh.components};

  // The space has one vertex per input point: join the mesh's vertices on the same point, then along edges.
  const std::size_t points =
      complex.input_index.empty() ? 0 : *std::max_element(complex.input_index.begin(), complex.input_index.end()) + 1u;
  std::vector<std::size_t> parent(points);
  std::vector<unsigned char> rank(points, 0);
  std::vector<bool> covered(points, false);
  boost::disjoint_sets<unsigned char*, std::size_t*> sets(rank.data(), parent.data());
  for (const std::uint32_t p : complex.input_index) {
    if (covered[p]) continue;
    covered[p] = true;
    sets.make_set(p);
    ++counts.points_covered;
  }
  counts.components = counts.points_covered;
  for (int e = 0; e < static_cast<int>(mesh.edges); ++e) {
    const auto h = complex.mesh.halfedge_handle(meshops::Edge(e), 0);
    const auto end = [&](meshops::Vertex v) {
      return sets.find_set(complex.input_index[static_cast<std::size_t>(v.idx())]);
    };
    const std::size_t a = end(complex.mesh.from_vertex_handle(h)), b = end(complex.mesh.to_vertex_handle(h));
    if (a == b) continue;
    sets.link(a, b);
    --counts.components;
  }
  counts.holes = counts.components + counts.edges - counts.points_covered - counts.triangles;
  return counts;
}

}  // namespace rbpa

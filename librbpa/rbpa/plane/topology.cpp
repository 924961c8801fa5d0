#include "rbpa/plane/topology.h"

#include <algorithm>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "meshops/topology/count.h"
#include "rbpa/plane/complex.h"

namespace rbpa {

ComplexCounts count(const SolidAlphaComplex& complex) {
  const meshops::TopologyCounts mesh = meshops::count_topology(complex.mesh);
  ComplexCounts counts{.edges = mesh.edges,
                       .triangles = mesh.faces,
                       .boundary_curves = mesh.boundary_curves,
                       .solid_components = mesh.components};

  // The space has one vertex for each input point that carries vertices of the mesh, and its components are joined
  // along edges: pinches connect.
  const std::size_t points =
      complex.input_index.empty() ? 0 : *std::max_element(complex.input_index.begin(), complex.input_index.end()) + 1u;
  std::vector<bool> covered(points, false);
  meshops::DisjointSets components(points);
  for (const std::uint32_t p : complex.input_index) {
    if (covered[p]) continue;
    covered[p] = true;
    ++counts.points_covered;
  }
  counts.components = counts.points_covered;
  for (int e = 0; e < static_cast<int>(mesh.edges); ++e) {
    const auto h = complex.mesh.halfedge_handle(meshops::Edge(e), 0);
    const auto end = [&](meshops::Vertex v) { return complex.input_index[static_cast<std::size_t>(v.idx())]; };
    counts.components -=
        components.join(end(complex.mesh.from_vertex_handle(h)), end(complex.mesh.to_vertex_handle(h)));
  }
  counts.holes = counts.components + counts.edges - counts.points_covered - counts.triangles;
  return counts;
}

}  // namespace rbpa

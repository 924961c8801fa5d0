// What: the solid components of a complex: vertices of the mesh, or triangles in arrays, that hang together through edges.
#pragma once

#include <cstdint>

#include "meshops/topology/disjoint_sets.h"
#include "rbpa/base/triangle_arrays.h"
#include "rbpa/mesh.h"
#include "rbpa/plane/shape/steps.h"

namespace rbpa {

/// Sets of vertices of the mesh. Throws Cancelled; every edge is a step.
inline meshops::DisjointSets components_of(const Mesh& mesh, Steps& step) {
  meshops::DisjointSets components(mesh.n_vertices());
  for (const auto edge : mesh.edges()) {
    step();
    const auto h = mesh.halfedge_handle(edge, 0);
    components.unite(static_cast<std::uint32_t>(mesh.from_vertex_handle(h).idx()),
                     static_cast<std::uint32_t>(mesh.to_vertex_handle(h).idx()));
  }
  return components;
}

/// Sets of triangles. Throws Cancelled; every triangle is a step.
inline meshops::DisjointSets components_of(const TriangleArrays& complex, Steps& step) {
  const auto triangles = static_cast<std::uint32_t>(complex.triangles.size());
  meshops::DisjointSets components(triangles);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    step();
    for (const std::uint32_t other : complex.neighbors[t])
      if (other < t) components.unite(t, other);
  }
  return components;
}

}  // namespace rbpa

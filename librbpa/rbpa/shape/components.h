// What: the solid components of a complex: vertices of the mesh that hang together through edges.
#pragma once

#include "meshops/topology/disjoint_sets.h"
#include "rbpa/core/mesh.h"
#include "rbpa/shape/steps.h"

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

}  // namespace rbpa

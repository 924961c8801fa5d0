// What: values on the edges of a mesh as a property map of Boost, for weights and capacities.
// Law:  both halfedges of an edge have the same value.
#pragma once

#include <boost/property_map/function_property_map.hpp>
#include <cstddef>
#include <utility>

#include "meshops/core/connectivity.h"
#include "meshops/core/contract.h"

namespace meshops {

/// Returns the read-only map from a halfedge to of_edge(its edge), by value. The map owns `of_edge`, and Boost copies
/// maps: let `of_edge` refer to large data instead of holding them.
/// Requires: a const `of_edge` accepts an Edge. The edge is not checked.
template <typename OfEdge>
auto edge_map(OfEdge of_edge) {
  // OpenMesh keeps the halfedges of edge e at 2e and 2e + 1.
  return boost::make_function_property_map<Halfedge>(
      [of_edge = std::move(of_edge)](Halfedge h) { return of_edge(Edge(h.idx() >> 1)); });
}

/// Returns the map from a halfedge to the distance between its ends: norm() of their difference, converted to double,
/// computed at each read.
/// Requires: `mesh` derives from Connectivity and has point(Vertex), the difference of two points has norm(), and
///           `mesh` outlives the map.
/// Throws:   ContractViolation when the map is read for an edge that does not exist.
template <typename Mesh>
auto length_map(const Mesh& mesh) {
  return edge_map([&mesh](Edge e) {
    require(e.idx() >= 0 && static_cast<std::size_t>(e.idx()) < mesh.Connectivity::n_edges(), "length_map: edge ",
            e.idx(), " does not exist");
    const Halfedge h = mesh.halfedge_handle(e, 0);
    const auto along = mesh.point(mesh.to_vertex_handle(h)) - mesh.point(mesh.from_vertex_handle(h));
    return static_cast<double>(along.norm());
  });
}
template <typename Mesh>
void length_map(const Mesh&&) = delete;  // the map would outlive the mesh

}  // namespace meshops

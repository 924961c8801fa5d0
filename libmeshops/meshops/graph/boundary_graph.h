// What: the boundary of a mesh as a graph of Boost, with only its boundary vertices and boundary edges.
// Law:  every vertex of the undirected graph has degree 2. The components are the boundary curves, each a cycle.
#pragma once

#include "meshops/core/live.h"
#include "meshops/graph/graph_view.h"

namespace meshops {
namespace detail {

struct Boundary {
  using Node = Vertex;
  static bool has(const Connectivity& mesh, Vertex v) {
    return is_live(mesh, v) && !mesh.is_isolated(v) && mesh.is_boundary(v);
  }
  static bool has(const Connectivity& mesh, Halfedge h) {
    return is_live(mesh, h) && (mesh.is_boundary(h) || mesh.is_boundary(mesh.opposite_halfedge_handle(h)));
  }
  static bool names_edge(const Connectivity& mesh, Halfedge h) { return mesh.is_boundary(h); }
  static Vertex source(const Connectivity& mesh, Halfedge h) { return mesh.from_vertex_handle(h); }
  // The halfedge of a boundary vertex is a boundary halfedge: this is OpenMesh's convention, which validate() checks.
  static Halfedge first_leaving(const Connectivity& mesh, Vertex v) { return mesh.halfedge_handle(v); }
  static Halfedge next_leaving(const Connectivity& mesh, Halfedge h) {
    return mesh.is_boundary(h) ? mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h))
                               : mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
  }
};

}  // namespace detail

/// Graph of the boundary. edges() lists each edge by its boundary halfedge, so that edges run along the curves, with
/// the mesh on their right. An inner edge that joins two boundary vertices is not in the graph. Vertices and edges keep
/// the indices of the mesh, which have gaps in the graph: see num_vertices().
using BoundaryGraph = GraphView<detail::Boundary, boost::undirected_tag>;

}  // namespace meshops

// What: the vertices and edges of a mesh as a graph of Boost.
// Law:  a halfedge is an edge whose source is its from-vertex and whose target is its to-vertex. The connected
//       components of the graph are the components of the mesh.
#pragma once

#include "meshops/core/live.h"
#include "meshops/graph/graph_view.h"

namespace meshops {
namespace detail {

struct Primal {
  using Node = Vertex;
  static bool has(const Connectivity& mesh, Vertex v) { return is_live(mesh, v); }
  static bool has(const Connectivity& mesh, Halfedge h) { return is_live(mesh, h); }
  static bool names_edge(const Connectivity&, Halfedge h) { return h.idx() % 2 == 0; }
  static Vertex source(const Connectivity& mesh, Halfedge h) { return mesh.from_vertex_handle(h); }
  static Halfedge first_leaving(const Connectivity& mesh, Vertex v) { return mesh.halfedge_handle(v); }
  static Halfedge next_leaving(const Connectivity& mesh, Halfedge h) {
    return mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(h));
  }
};

}  // namespace detail

/// Graph of the vertices, including isolated ones. edges() lists each edge by its first halfedge.
using PrimalGraph = GraphView<detail::Primal, boost::undirected_tag>;

}  // namespace meshops

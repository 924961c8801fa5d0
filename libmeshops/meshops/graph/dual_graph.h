// What: the faces of a mesh as a graph of Boost, joined across its inner edges.
// Law:  halfedge h runs from its face to the face of its opposite. The components of the graph are the components of
//       the mesh that have faces.
#pragma once

#include "meshops/core/live.h"
#include "meshops/graph/graph_view.h"

namespace meshops {
namespace detail {

struct Dual {
  using Node = Face;
  static bool is_inner(const Connectivity& mesh, Halfedge h) {
    return !mesh.is_boundary(h) && !mesh.is_boundary(mesh.opposite_halfedge_handle(h));
  }
  static bool has(const Connectivity& mesh, Face f) { return is_live(mesh, f); }
  static bool has(const Connectivity& mesh, Halfedge h) { return is_live(mesh, h) && is_inner(mesh, h); }
  static bool names_edge(const Connectivity&, Halfedge h) { return h.idx() % 2 == 0; }
  static Face source(const Connectivity& mesh, Halfedge h) { return mesh.face_handle(h); }
  static Halfedge first_leaving(const Connectivity& mesh, Face f) {
    const Halfedge any = mesh.halfedge_handle(f);
    Halfedge h = any;
    while (!is_inner(mesh, h)) {
      h = mesh.next_halfedge_handle(h);
      if (h == any) return Halfedge();
    }
    return h;
  }
  static Halfedge next_leaving(const Connectivity& mesh, Halfedge h) {
    do {
      h = mesh.next_halfedge_handle(h);
    } while (!is_inner(mesh, h));
    return h;
  }
};

}  // namespace detail

/// Graph of the faces. Two faces with several common edges are joined by as many edges. edges() lists each inner edge
/// by its first halfedge. Cost of a step around a face: constant, plus the boundary edges that it skips.
using DualGraph = GraphView<detail::Dual, boost::undirected_tag>;

}  // namespace meshops

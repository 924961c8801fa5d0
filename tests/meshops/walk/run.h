// Computes the arguments of a split of a vertex, from the ring of the vertex.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meshops/core/live.h"
#include "support/meshes.h"

namespace meshops::test {

/// Arguments of a split of a vertex, found on the ring of the vertex.
struct Run {
  std::string reason;        ///< why there are none
  std::vector<int> sides;    ///< from left to right
  std::vector<int> one_fan;  ///< the vertex, if it must have one

  Run(const TestMesh& mesh, std::optional<Halfedge> left, std::optional<Halfedge> right) {
    for (const auto& h : {left, right})
      if (h && !is_live(mesh, *h)) reason = "no such side";
    if (!left && !right) reason = "nothing given";
    if (!reason.empty()) return;
    const Vertex w = mesh.from_vertex_handle(left ? *left : *right);
    if (right && mesh.from_vertex_handle(*right) != w) reason = "two vertices";
    if ((!left || !right) && !mesh.is_boundary(w)) reason = "no boundary";
    if (!reason.empty()) return;
    const Halfedge named = mesh.halfedge_handle(w);
    // A gap lies after each boundary side of the turn. If one side is left out, the gap after the named side is the
    // end.
    int gaps_within = left && mesh.is_boundary(*left) && (right || *left != named) ? 1 : 0, gaps = 0;
    const Halfedge first = turned(mesh, left ? *left : named), end = right ? *right : turned(mesh, named);
    for (Halfedge h = first; h != end; h = turned(mesh, h)) {
      sides.push_back(h.idx());
      gaps_within += mesh.is_boundary(h) && (right || h != named);
    }
    Halfedge h = named;
    do {
      gaps += mesh.is_boundary(h);
      h = turned(mesh, h);
    } while (h != named);
    if (gaps_within > 0 && gaps > 1) one_fan = {w.idx()};
  }

 private:
  static Halfedge turned(const Connectivity& mesh, Halfedge h) {
    return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
  }
};

}  // namespace meshops::test

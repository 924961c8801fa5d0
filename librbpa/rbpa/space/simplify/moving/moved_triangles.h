// What: visits the triangles that change when an edge collapses: those at an end that moves, except those that vanish.
#pragma once

#include <cstddef>
#include <span>
#include <utility>

#include "meshops/core/connectivity.h"
#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Calls visit(old, second, third) for each triangle of which a corner would move from `old` to `place` if the edge
/// collapsed, until visit() returns false. The other corners are in the order of the triangle. Returns whether visit()
/// never returned false. Requires: triangles; a place for each vertex.
template <typename Visit>
bool for_each_moved_triangle(const meshops::Connectivity& mesh, meshops::Edge e, std::span<const Point3> places,
                             const Point3& place, const Visit& visit) {
  const auto at = [&](meshops::Vertex v) { return places[static_cast<std::size_t>(v.idx())]; };
  const meshops::Halfedge h = mesh.halfedge_handle(e, 0);
  const meshops::Vertex a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
  for (const auto& [moved, other] : {std::pair(a, b), std::pair(b, a)}) {
    if (at(moved) == place) continue;
    for (const meshops::Halfedge out : mesh.voh_range(moved)) {
      const meshops::Vertex second = mesh.to_vertex_handle(out),
                            third = mesh.to_vertex_handle(mesh.next_halfedge_handle(out));
      if (mesh.is_boundary(out) || second == other || third == other) continue;
      if (!visit(at(moved), at(second), at(third))) return false;
    }
  }
  return true;
}

}  // namespace rbpa::space

#include "meshops/handle/separate_fans.h"

#include "meshops/core/live.h"

namespace meshops {
namespace {

/// Sets `fan` to the halfedges by which a fan leaves its vertex, clockwise; `any` is one of them. The first halfedge of
/// an open fan is its boundary halfedge.
void collect_fan(const Connectivity& mesh, Halfedge any, std::vector<Halfedge>& fan) {
  Halfedge first = any;
  while (!mesh.is_boundary(first)) {
    first = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(first));
    if (first == any) break;
  }
  fan.assign(1, first);
  for (Halfedge in = mesh.opposite_halfedge_handle(first); !mesh.is_boundary(in);) {
    const Halfedge out = mesh.next_halfedge_handle(in);
    if (out == first) break;
    fan.push_back(out);
    in = mesh.opposite_halfedge_handle(out);
  }
}

}  // namespace

std::vector<Vertex> separate_fans(Connectivity& mesh) {
  std::vector<Vertex> copied;
  std::vector<bool> seen(mesh.n_halfedges(), false), has_fan(mesh.n_vertices(), false);
  std::vector<Halfedge> fan;
  for_each_halfedge(mesh, [&](Halfedge h) {
    if (seen[static_cast<std::size_t>(h.idx())]) return;
    collect_fan(mesh, h, fan);
    bool is_named = false;
    Vertex v = mesh.from_vertex_handle(h);
    for (const Halfedge out : fan) {
      seen[static_cast<std::size_t>(out.idx())] = true;
      is_named = is_named || out == mesh.halfedge_handle(v);
    }
    if (has_fan[static_cast<std::size_t>(v.idx())]) {
      copied.push_back(v);
      const Vertex copy = mesh.new_vertex();
      mesh.copy_all_properties(v, copy, true);
      for (const Halfedge out : fan) mesh.set_vertex_handle(mesh.opposite_halfedge_handle(out), copy);
      v = copy;
      is_named = false;
    } else {
      has_fan[static_cast<std::size_t>(v.idx())] = true;
    }
    const bool is_open = mesh.is_boundary(fan.front());
    if (is_open) mesh.set_next_halfedge_handle(mesh.opposite_halfedge_handle(fan.back()), fan.front());
    if (is_open || !is_named) mesh.set_halfedge_handle(v, fan.front());
  });
  return copied;
}

}  // namespace meshops

#include "meshops/handle/glue.h"

#include <vector>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/handle/insert_triangle.h"

namespace meshops {
namespace {

bool are_neighbours(const Connectivity& mesh, Vertex a, Vertex b) {
  const Halfedge first = mesh.halfedge_handle(a);
  Halfedge out = first;
  do {
    if (mesh.to_vertex_handle(out) == b) return true;
    out = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(out));
  } while (out != first);
  return false;
}

bool on_same_curve(const Connectivity& mesh, Halfedge first, Halfedge second) {
  Halfedge h = first;
  do {
    if (h == second) return true;
    h = mesh.next_halfedge_handle(h);
  } while (h != first);
  return false;
}

bool in_same_component(const Connectivity& mesh, Halfedge first, Halfedge second) {
  std::vector<char> seen(mesh.n_edges(), 0);
  std::vector<Halfedge> open = {first};
  seen[static_cast<std::size_t>(mesh.edge_handle(first).idx())] = 1;
  const Edge target = mesh.edge_handle(second);
  while (!open.empty()) {
    const Halfedge h = open.back();
    open.pop_back();
    if (mesh.edge_handle(h) == target) return true;
    for (const Halfedge side : {h, mesh.opposite_halfedge_handle(h)}) {
      const Halfedge next = mesh.next_halfedge_handle(side);
      char& mark = seen[static_cast<std::size_t>(mesh.edge_handle(next).idx())];
      if (!mark) {
        mark = 1;
        open.push_back(next);
      }
    }
  }
  return false;
}

/// Merges the fans of two vertices and returns the survivor.
Vertex merge(Connectivity& mesh, Vertex a, Vertex b) {
  if (a == b) return a;
  const Vertex survivor = a.idx() < b.idx() ? a : b;
  const Vertex loser = a.idx() < b.idx() ? b : a;
  detail::move_fan(mesh, loser, survivor);
  mesh.set_isolated(loser);
  mesh.status(loser).set_deleted(true);
  return survivor;
}

}  // namespace

std::optional<std::string> glue_blocker(const Connectivity& mesh, Halfedge first, Halfedge second) {
  if (!is_live(mesh, first) || !is_live(mesh, second)) return "no such halfedge";
  if (mesh.edge_handle(first) == mesh.edge_handle(second)) return "both halfedges are of one edge";
  if (!mesh.is_boundary(first) || !mesh.is_boundary(second)) return "a halfedge is not on the boundary";
  const Vertex a0 = mesh.from_vertex_handle(first), a1 = mesh.to_vertex_handle(second);
  const Vertex b0 = mesh.to_vertex_handle(first), b1 = mesh.from_vertex_handle(second);
  if ((a0 != a1 && are_neighbours(mesh, a0, a1)) || (b0 != b1 && are_neighbours(mesh, b0, b1)))
    return "an edge joins two vertices that would become one";
  return std::nullopt;
}

GlueCase glue_case(const Connectivity& mesh, Halfedge first, Halfedge second) {
  const bool adjacent_at_end = mesh.next_halfedge_handle(first) == second;
  const bool adjacent_at_start = mesh.next_halfedge_handle(second) == first;
  if (adjacent_at_end && adjacent_at_start) return GlueCase::close;
  if (adjacent_at_end || adjacent_at_start) return GlueCase::zip;
  if (on_same_curve(mesh, first, second)) return GlueCase::split_curve;
  return in_same_component(mesh, first, second) ? GlueCase::handle : GlueCase::join;
}

GlueEffect glue(Connectivity& mesh, Halfedge first, Halfedge second) {
  require(mesh.has_vertex_status() && mesh.has_halfedge_status() && mesh.has_edge_status(),
          "glue: the mesh needs vertex, halfedge and edge status to mark what is deleted");
  if (const auto blocker = glue_blocker(mesh, first, second)) throw ContractViolation("glue: " + *blocker);
  const GlueEffect effect{glue_case(mesh, first, second), first};

  const Halfedge before_first = mesh.prev_halfedge_handle(first), after_first = mesh.next_halfedge_handle(first);
  const Halfedge before_second = mesh.prev_halfedge_handle(second), after_second = mesh.next_halfedge_handle(second);
  const Halfedge inner = mesh.opposite_halfedge_handle(second);  // what `first` takes the place of
  const Halfedge inner_before = mesh.prev_halfedge_handle(inner), inner_after = mesh.next_halfedge_handle(inner);
  const Face face = mesh.face_handle(inner);

  const Vertex start = merge(mesh, mesh.from_vertex_handle(first), mesh.to_vertex_handle(second));
  const Vertex end = merge(mesh, mesh.to_vertex_handle(first), mesh.from_vertex_handle(second));

  // `first` replaces the opposite of `second` in its face.
  mesh.set_face_handle(first, face);
  if (face.is_valid() && mesh.halfedge_handle(face) == inner) mesh.set_halfedge_handle(face, first);
  mesh.set_next_halfedge_handle(inner_before, first);
  mesh.set_next_halfedge_handle(first, inner_after);

  // The boundary passes by the glued edge at each end, unless the curve closes there.
  const Halfedge opposite = mesh.opposite_halfedge_handle(first);
  if (after_first == second) {
    mesh.set_halfedge_handle(end, opposite);
  } else {
    mesh.set_next_halfedge_handle(before_second, after_first);
    mesh.set_halfedge_handle(end, after_first);
  }
  if (after_second == first) {
    mesh.set_halfedge_handle(start, first);
  } else {
    mesh.set_next_halfedge_handle(before_first, after_second);
    mesh.set_halfedge_handle(start, after_second);
  }

  mesh.status(mesh.edge_handle(second)).set_deleted(true);
  mesh.status(second).set_deleted(true);
  mesh.status(inner).set_deleted(true);
  return effect;
}

}  // namespace meshops

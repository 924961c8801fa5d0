#include "meshops/handle/extract_triangle.h"

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/handle/fan.h"

namespace meshops {

TriangleRim rim_of(const Connectivity& mesh, Face f) {
  require(is_live(mesh, f), "rim_of: face ", f.idx(), " does not exist or is deleted");
  TriangleRim rim;
  Halfedge side = mesh.halfedge_handle(f);
  for (unsigned i = 0; i < 3; ++i, side = mesh.next_halfedge_handle(side)) {
    rim.side[i] = side;
    rim.corner[i] = mesh.from_vertex_handle(side);
    rim.is_glued[i] = !mesh.is_boundary(mesh.opposite_halfedge_handle(side));
  }
  require(side == rim.side[0], "rim_of: face ", f.idx(), " is not a triangle");
  for (unsigned i = 0; i < 3; ++i)
    rim.is_passage[i] = rim.is_glued[i] && rim.is_glued[(i + 2) % 3] && mesh.is_boundary(rim.corner[i]);
  return rim;
}

void extract_triangle(Connectivity& mesh, const TriangleRim& rim, const std::array<Vertex, 3>& second) {
  const Face face = mesh.face_handle(rim.side[0]);
  for (unsigned i = 0; i < 3; ++i) {
    const Vertex v = rim.corner[i];
    const Halfedge out = rim.side[i], in = rim.side[(i + 2) % 3];
    const bool out_stays = rim.is_glued[i], in_stays = rim.is_glued[(i + 2) % 3];
    if (!out_stays && !in_stays) {
      mesh.set_isolated(v);
      continue;
    }
    // The boundary passes through the gap that the removed triangle leaves at the corner.
    const bool on_boundary = mesh.is_boundary(v);
    const Halfedge after = mesh.halfedge_handle(v);
    const Halfedge before = on_boundary ? mesh.prev_halfedge_handle(after) : Halfedge();
    if (!on_boundary) {
      mesh.set_halfedge_handle(v, out);
    } else if (!in_stays) {
      mesh.set_next_halfedge_handle(before, out);
      mesh.set_halfedge_handle(v, out);
    } else {
      mesh.set_next_halfedge_handle(in, after);
      if (!out_stays) continue;
      mesh.set_next_halfedge_handle(before, out);
      mesh.set_halfedge_handle(second[i], out);
      detail::move_fan(mesh, out, second[i]);
    }
  }
  for (unsigned i = 0; i < 3; ++i) {
    if (rim.is_glued[i]) {
      mesh.set_boundary(rim.side[i]);
      continue;
    }
    mesh.status(mesh.edge_handle(rim.side[i])).set_deleted(true);
    mesh.status(rim.side[i]).set_deleted(true);
    mesh.status(mesh.opposite_halfedge_handle(rim.side[i])).set_deleted(true);
  }
  mesh.status(face).set_deleted(true);
}

}  // namespace meshops

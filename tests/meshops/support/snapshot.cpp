#include "support/snapshot.h"

#include "meshops/core/live.h"

namespace meshops::test {
namespace {

std::vector<int> records(const Connectivity& mesh, bool live_only, bool named) {
  std::vector<int> all;
  const auto element = [&](auto handle) {
    if (live_only && !is_live(mesh, handle)) return false;
    all.push_back(handle.idx());
    return true;
  };
  for (int i = 0; i < static_cast<int>(mesh.n_vertices()); ++i)
    if (const Vertex v(i); element(v)) {
      if (named || mesh.is_isolated(v) || mesh.is_boundary(v)) all.push_back(mesh.halfedge_handle(v).idx());
      if (mesh.has_vertex_status()) all.push_back(static_cast<int>(mesh.status(v).bits()));
    }
  for (int i = 0; i < static_cast<int>(mesh.n_halfedges()); ++i)
    if (const Halfedge h(i); element(h)) {
      all.insert(all.end(), {mesh.to_vertex_handle(h).idx(), mesh.next_halfedge_handle(h).idx(),
                             mesh.prev_halfedge_handle(h).idx(), mesh.face_handle(h).idx()});
      if (mesh.has_halfedge_status()) all.push_back(static_cast<int>(mesh.status(h).bits()));
      if (mesh.has_edge_status()) all.push_back(static_cast<int>(mesh.status(mesh.edge_handle(h)).bits()));
    }
  for (int i = 0; i < static_cast<int>(mesh.n_faces()); ++i)
    if (const Face f(i); element(f)) {
      all.push_back(mesh.halfedge_handle(f).idx());
      if (mesh.has_face_status()) all.push_back(static_cast<int>(mesh.status(f).bits()));
    }
  return all;
}

}  // namespace

std::vector<int> snapshot(const Connectivity& mesh) { return records(mesh, false, true); }
std::vector<int> live_snapshot(const Connectivity& mesh, Named named) {
  return records(mesh, true, named == Named::compared);
}

}  // namespace meshops::test

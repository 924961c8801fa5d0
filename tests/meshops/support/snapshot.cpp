#include "support/snapshot.h"

#include "meshops/core/live.h"

namespace meshops::test {
namespace {

std::vector<int> records(const Connectivity& mesh, bool live_only) {
  std::vector<int> all;
  const auto section = [&](std::size_t count, auto handle_of, auto record) {
    const std::size_t begin = all.size();
    std::size_t end = begin;  // of the last live element
    for (int i = 0; i < static_cast<int>(count); ++i) {
      const auto handle = handle_of(i);
      all.push_back(is_live(mesh, handle));
      if (!live_only || is_live(mesh, handle)) record(handle);
      if (is_live(mesh, handle)) end = all.size();
    }
    // A live tail that is followed by deleted elements equals the same tail without them.
    if (live_only) all.resize(end);
    all.push_back(static_cast<int>(all.size() - begin));
  };
  section(
      mesh.n_vertices(), [](int i) { return Vertex(i); },
      [&](Vertex v) {
        all.push_back(mesh.halfedge_handle(v).idx());
        if (mesh.has_vertex_status()) all.push_back(static_cast<int>(mesh.status(v).bits()));
      });
  section(
      mesh.n_halfedges(), [](int i) { return Halfedge(i); },
      [&](Halfedge h) {
        all.insert(all.end(), {mesh.to_vertex_handle(h).idx(), mesh.next_halfedge_handle(h).idx(),
                               mesh.prev_halfedge_handle(h).idx(), mesh.face_handle(h).idx()});
        if (mesh.has_halfedge_status()) all.push_back(static_cast<int>(mesh.status(h).bits()));
        if (mesh.has_edge_status()) all.push_back(static_cast<int>(mesh.status(mesh.edge_handle(h)).bits()));
      });
  section(
      mesh.n_faces(), [](int i) { return Face(i); },
      [&](Face f) {
        all.push_back(mesh.halfedge_handle(f).idx());
        if (mesh.has_face_status()) all.push_back(static_cast<int>(mesh.status(f).bits()));
      });
  return all;
}

}  // namespace

std::vector<int> snapshot(const Connectivity& mesh) { return records(mesh, false); }
std::vector<int> live_snapshot(const Connectivity& mesh) { return records(mesh, true); }

}  // namespace meshops::test

#include "support/soundness.h"

#include <algorithm>
#include <map>
#include <vector>

#include "meshops/core/live.h"

namespace meshops::test {
namespace {

template <typename Handle>
using Star = std::map<Handle, std::vector<Halfedge>>;

bool records_name_live_elements(const Connectivity& mesh) {
  bool all = true;
  for_each_halfedge(mesh, [&](Halfedge h) {
    const Face f = mesh.face_handle(h);
    all = all && is_live(mesh, mesh.to_vertex_handle(h)) && is_live(mesh, mesh.next_halfedge_handle(h)) &&
          is_live(mesh, mesh.prev_halfedge_handle(h)) && (!f.is_valid() || is_live(mesh, f));
  });
  for_each_face(mesh, [&](Face f) { all = all && is_live(mesh, mesh.halfedge_handle(f)); });
  for_each_vertex(mesh, [&](Vertex v) {
    const Halfedge named = mesh.halfedge_handle(v);
    all = all && (!named.is_valid() || is_live(mesh, named));
  });
  return all;
}

bool halfedges_agree(const Connectivity& mesh) {
  bool all = true;
  for_each_halfedge(mesh, [&](Halfedge h) {
    const Halfedge next = mesh.next_halfedge_handle(h), back = mesh.opposite_halfedge_handle(h);
    const bool has_face = mesh.face_handle(h).is_valid() || mesh.face_handle(back).is_valid();
    all = all && mesh.prev_halfedge_handle(next) == h && mesh.next_halfedge_handle(mesh.prev_halfedge_handle(h)) == h &&
          mesh.from_vertex_handle(next) == mesh.to_vertex_handle(h) && mesh.face_handle(next) == mesh.face_handle(h) &&
          has_face && mesh.to_vertex_handle(h) != mesh.to_vertex_handle(back);
  });
  return all;
}

/// Returns whether the sides are one loop. Requires: next is a permutation.
bool is_one_loop(const Connectivity& mesh, Halfedge named, std::vector<Halfedge> sides) {
  std::vector<Halfedge> loop = {named};
  for (Halfedge h = mesh.next_halfedge_handle(named); h != named; h = mesh.next_halfedge_handle(h)) loop.push_back(h);
  std::sort(loop.begin(), loop.end());
  std::sort(sides.begin(), sides.end());
  return loop == sides && sides.size() >= 3;
}

/// Returns whether the edges around a vertex form one path or one circle. `out` are all halfedges that leave the
/// vertex. Each that has a face joins its edge to the one before it around the vertex, which is the other side of the
/// same corner.
bool is_path_or_circle(const Connectivity& mesh, const std::vector<Halfedge>& out) {
  std::vector<Halfedge> reached = {out.front()};
  std::size_t corners = 0;
  for (const Halfedge h : out) corners += mesh.face_handle(h).is_valid();
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const Halfedge h : out) {
      const auto joins = [&](Halfedge a, Halfedge b) {
        return mesh.face_handle(a).is_valid() && mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(a)) == b;
      };
      if ((joins(reached[i], h) || joins(h, reached[i])) && std::count(reached.begin(), reached.end(), h) == 0)
        reached.push_back(h);
    }
  return reached.size() == out.size() && (corners == out.size() || corners + 1 == out.size());
}

}  // namespace

bool is_sound_by_definition(const Connectivity& mesh) {
  if (!records_name_live_elements(mesh) || !halfedges_agree(mesh)) return false;
  Star<Vertex> leaving;
  Star<Face> sides;
  for_each_halfedge(mesh, [&](Halfedge h) {
    leaving[mesh.from_vertex_handle(h)].push_back(h);
    if (mesh.face_handle(h).is_valid()) sides[mesh.face_handle(h)].push_back(h);
  });
  bool sound = true;
  for_each_face(mesh, [&](Face f) { sound = sound && is_one_loop(mesh, mesh.halfedge_handle(f), sides[f]); });
  for_each_vertex(mesh, [&](Vertex v) {
    const Halfedge named = mesh.halfedge_handle(v);
    const auto out = leaving.find(v);
    if (!named.is_valid() || out == leaving.end()) {
      sound = sound && !named.is_valid() && out == leaving.end();
      return;
    }
    const auto& all = out->second;
    const bool is_inner =
        std::all_of(all.begin(), all.end(), [&](Halfedge h) { return mesh.face_handle(h).is_valid(); });
    sound = sound && mesh.from_vertex_handle(named) == v && (is_inner || !mesh.face_handle(named).is_valid()) &&
            is_path_or_circle(mesh, all);
  });
  return sound;
}

}  // namespace meshops::test

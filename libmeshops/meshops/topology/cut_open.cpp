#include "meshops/topology/cut_open.h"

#include <algorithm>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "meshops/core/live_range.h"

namespace meshops {
namespace {

std::uint32_t number(Vertex v) { return static_cast<std::uint32_t>(v.idx()); }

/// Returns the least edge of each component that has neither a boundary nor any of the given edges, ascending.
std::vector<Edge> seams_of_spheres(const Connectivity& mesh, std::span<const Edge> cut) {
  DisjointSets connected(mesh.n_vertices());
  const auto ends = [&](Edge e) {
    const Halfedge h = mesh.halfedge_handle(e, 0);
    return std::pair(number(mesh.from_vertex_handle(h)), number(mesh.to_vertex_handle(h)));
  };
  for (const Edge e : live_edges(mesh)) connected.unite(ends(e).first, ends(e).second);
  std::vector<char> has_seam(mesh.n_vertices(), 0);
  const auto seam = [&](Edge e) -> char& { return has_seam[connected.find(ends(e).first)]; };
  for (const Edge e : cut) seam(e) = 1;
  for (const Edge e : live_edges(mesh))
    if (mesh.is_boundary(e)) seam(e) = 1;
  std::vector<Edge> seams;
  for (const Edge e : live_edges(mesh))
    if (!seam(e)) {
      seam(e) = 1;
      seams.push_back(e);
    }
  return seams;
}

}  // namespace

std::optional<Blocker> cut_open_blocker(const Connectivity& mesh, std::span<const Edge> edges) {
  for (const Edge e : edges) {
    if (!is_live(mesh, e)) return Blocker(BlockerKind::missing, e);
    if (const auto blocker = unglue_blocker(mesh, mesh.halfedge_handle(e, 0))) return blocker;
  }
  std::vector<Edge> sorted(edges.begin(), edges.end());
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    return Blocker(BlockerKind::named_twice, *twice);
  return std::nullopt;
}

std::vector<UnglueEffect> cut_open(Connectivity& mesh, std::span<const Edge> edges) {
  detail::enforce("cut_open", cut_open_blocker(mesh, edges));
  std::vector<UnglueEffect> cuts;
  cuts.reserve(edges.size());
  // A cut edge keeps its handle on one side, and no other edge changes its handle.
  for (const Edge e : edges) cuts.push_back(unglue(mesh, mesh.halfedge_handle(e, 0)));
  return cuts;
}

std::vector<UnglueEffect> cut_open(Connectivity& mesh, const Homology& homology) {
  std::vector<Edge> edges = homology.cut_graph;
  detail::enforce("cut_open", cut_open_blocker(mesh, edges));
  const std::vector<Edge> seams = seams_of_spheres(mesh, edges);
  edges.insert(edges.end(), seams.begin(), seams.end());
  return cut_open(mesh, edges);
}

void glue_back(Connectivity& mesh, std::span<const UnglueEffect> cuts) {
  for (std::size_t i = cuts.size(); i-- > 0;) glue(mesh, cuts[i].first, cuts[i].second);
}

}  // namespace meshops

#include "meshops/topology/report.h"

#include <algorithm>
#include <utility>

#include "meshops/core/contract.h"
#include "meshops/core/disjoint_sets.h"
#include "meshops/core/live.h"
#include "meshops/handle/separate_fans.h"

namespace meshops {
namespace {

/// Returns whether the boundary passes some vertex more than once, or a halfedge is not in the ring of its vertex.
bool has_several_fans_anywhere(const Connectivity& mesh, Steps& step) {
  std::size_t in_rings = 0, halfedges = 0;
  bool found = false;
  for_each_vertex(mesh, [&](Vertex v) {
    const Halfedge first = mesh.halfedge_handle(v);
    if (!first.is_valid() || found) return;
    int gaps = 0;
    Halfedge out = first;
    do {
      step();
      ++in_rings;
      gaps += mesh.is_boundary(out);
      out = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(out));
    } while (out != first);
    found = gaps > 1;
  });
  for_each_edge(mesh, [&](OpenMesh::EdgeHandle) { halfedges += 2; });
  return found || in_rings != halfedges;
}

/// Reporter on a mesh whose vertices have one fan each; it takes the same steps as SoupReporter.
class MeshReporter {
 public:
  MeshReporter(const Connectivity& mesh, std::span<const std::uint32_t> point_of_vertex, Steps& step)
      : mesh_(mesh), point_of_vertex_(point_of_vertex), step_(step), vertices_(mesh.n_vertices()) {}

  TopologyReport operator()() {
    find_pieces();
    count_edges();
    count_curves();
    count_points();
    total_.genus = 0;
    long closed = 0;
    for (const ComponentReport& piece : total_.per_component) {
      *total_.genus += *piece.genus();
      closed += piece.betti()[2];
    }
    total_.solid_components = total_.per_component.size();
    const long b0 = static_cast<long>(total_.components);
    total_.betti = {b0, b0 + closed - total_.euler(), closed};
    return std::move(total_);
  }

 private:
  /// Finds the pieces of surface, in the order of their first faces.
  void find_pieces() {
    for_each_edge(mesh_, [&](OpenMesh::EdgeHandle e) {
      step_();
      const Halfedge h = mesh_.halfedge_handle(e, 0);
      vertices_.unite(index(mesh_.from_vertex_handle(h)), index(mesh_.to_vertex_handle(h)));
    });
    const std::size_t none = mesh_.n_vertices();
    piece_of_.assign(mesh_.n_vertices(), none);
    for_each_face(mesh_, [&](Face f) {
      step_();
      std::size_t& piece = piece_of_[root(mesh_.halfedge_handle(f))];
      if (piece == none) {
        piece = total_.per_component.size();
        total_.per_component.push_back({.first_face = static_cast<std::size_t>(f.idx())});
      }
      ++total_.per_component[piece].faces;
      ++total_.faces;
    });
  }

  void count_edges() {
    for_each_edge(mesh_, [&](OpenMesh::EdgeHandle e) {
      step_();
      ++piece_at(mesh_.halfedge_handle(e, 0)).edges;
      ++total_.edges;
    });
  }

  void count_curves() {
    std::vector<bool> is_known(mesh_.n_halfedges(), false);
    for_each_halfedge(mesh_, [&](Halfedge first) {
      step_();
      if (!mesh_.is_boundary(first) || is_known[index(first)]) return;
      ++piece_at(first).boundary_curves;
      ++total_.boundary_curves;
      for (Halfedge h = first; !is_known[index(h)]; h = mesh_.next_halfedge_handle(h)) {
        step_();
        is_known[index(h)] = true;
      }
    });
  }

  /// Counts the points on which several fans stand, and the components that are connected through points.
  void count_points() {
    std::size_t bound = mesh_.n_vertices();
    for (const std::uint32_t p : point_of_vertex_) bound = std::max(bound, p + std::size_t{1});
    require(bound <= std::size_t{1} << 31U, "report: found point ", static_cast<long long>(bound) - 1,
            ", expected points below 2^31");
    constexpr std::uint8_t unseen = 0xff, several = 2;
    std::vector<std::uint8_t> fans_at(bound, unseen);
    DisjointSets connected(bound);
    for_each_vertex(mesh_, [&](Vertex v) {
      step_();
      const std::uint32_t p = point_of(v);
      std::uint8_t& fans = fans_at[p];
      if (fans == unseen) {
        ++total_.vertices;
        fans = 0;
      }
      if (mesh_.is_isolated(v)) return;
      ++piece_at(mesh_.halfedge_handle(v)).vertices;
      if (fans == 1) ++total_.pinches;
      if (fans < several) ++fans;
      connected.unite(p, point_of(Vertex(static_cast<int>(vertices_.find(index(v))))));
    });
    for (std::uint32_t p = 0; p < bound; ++p) {
      if (fans_at[p] == 0) ++total_.isolated;
      if (fans_at[p] != unseen && connected.is_least(p)) ++total_.components;
    }
  }

  template <typename Handle>
  static std::uint32_t index(Handle element) {
    return static_cast<std::uint32_t>(element.idx());
  }
  std::uint32_t root(Halfedge h) { return vertices_.find(index(mesh_.from_vertex_handle(h))); }
  ComponentReport& piece_at(Halfedge h) { return total_.per_component[piece_of_[root(h)]]; }
  std::uint32_t point_of(Vertex v) const {
    return point_of_vertex_.empty() ? index(v) : point_of_vertex_[static_cast<std::size_t>(v.idx())];
  }

  const Connectivity& mesh_;
  std::span<const std::uint32_t> point_of_vertex_;
  Steps& step_;
  DisjointSets vertices_;              // vertices joined along edges: each set has the vertices of one piece
  std::vector<std::size_t> piece_of_;  // for the least vertex of each set
  TopologyReport total_;
};

/// Reports on a copy of the mesh in which each fan has its own vertex, on the old point.
TopologyReport report_of_fans(const Connectivity& mesh, std::span<const std::uint32_t> point_of_vertex,
                              const GoOn& go_on) {
  Connectivity parted = mesh;
  std::vector<std::uint32_t> points(point_of_vertex.begin(), point_of_vertex.end());
  for (auto v = static_cast<std::uint32_t>(points.size()); v < mesh.n_vertices(); ++v) points.push_back(v);
  for (const Vertex v : separate_fans(parted)) points.push_back(points[static_cast<std::size_t>(v.idx())]);
  return report(parted, points, go_on);
}

}  // namespace

TopologyReport report(const Connectivity& mesh, std::span<const std::uint32_t> point_of_vertex, const GoOn& go_on) {
  if (!point_of_vertex.empty())
    require_one_each("report", point_of_vertex.size(), "points", mesh.n_vertices(), "vertices");
  Steps step(go_on);
  if (has_several_fans_anywhere(mesh, step)) return report_of_fans(mesh, point_of_vertex, go_on);
  return MeshReporter(mesh, point_of_vertex, step)();
}

}  // namespace meshops

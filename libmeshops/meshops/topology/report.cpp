#include "meshops/topology/report.h"

#include <algorithm>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/handle/separate_fans.h"
#include "meshops/topology/disjoint_sets.h"

namespace meshops {
namespace {

/// A boundary passes a vertex more than once, or a halfedge is not in the ring of its vertex.
bool has_several_fans_anywhere(const Connectivity& mesh) {
  std::size_t in_rings = 0, halfedges = 0;
  bool found = false;
  for_each_vertex(mesh, [&](Vertex v) {
    const Halfedge first = mesh.halfedge_handle(v);
    if (!first.is_valid() || found) return;
    int gaps = 0;
    Halfedge out = first;
    do {
      ++in_rings;
      gaps += mesh.is_boundary(out);
      out = mesh.next_halfedge_handle(mesh.opposite_halfedge_handle(out));
    } while (out != first);
    found = gaps > 1;
  });
  for_each_edge(mesh, [&](OpenMesh::EdgeHandle) { halfedges += 2; });
  return found || in_rings != halfedges;
}

/// The report of a copy in which each fan has a vertex, on the same point.
TopologyReport report_of_fans(const Connectivity& mesh, std::span<const std::uint32_t> point_of_vertex) {
  Connectivity parted = mesh;
  std::vector<std::uint32_t> points(point_of_vertex.begin(), point_of_vertex.end());
  for (auto v = static_cast<std::uint32_t>(points.size()); v < mesh.n_vertices(); ++v) points.push_back(v);
  for (const Vertex v : separate_fans(parted)) points.push_back(points[static_cast<std::size_t>(v.idx())]);
  return report(parted, points);
}

}  // namespace

TopologyReport report(const Connectivity& mesh, std::span<const std::uint32_t> point_of_vertex) {
  require(point_of_vertex.empty() || point_of_vertex.size() == mesh.n_vertices(),
          "report: not one point for each vertex");
  if (has_several_fans_anywhere(mesh)) return report_of_fans(mesh, point_of_vertex);
  const auto index = [](auto element) { return static_cast<std::uint32_t>(element.idx()); };
  const auto point_of = [&](Vertex v) {
    return point_of_vertex.empty() ? index(v) : point_of_vertex[static_cast<std::size_t>(v.idx())];
  };
  TopologyReport total;
  DisjointSets pieces(mesh.n_vertices());
  for_each_edge(mesh, [&](OpenMesh::EdgeHandle e) {
    const Halfedge h = mesh.halfedge_handle(e, 0);
    pieces.unite(index(mesh.from_vertex_handle(h)), index(mesh.to_vertex_handle(h)));
  });

  // Pieces in the order of their first faces.
  std::vector<std::size_t> piece_of(mesh.n_vertices(), mesh.n_vertices());
  const auto piece_at = [&](Halfedge h) -> ComponentReport& {
    return total.per_component[piece_of[pieces.find(index(mesh.from_vertex_handle(h)))]];
  };
  for_each_face(mesh, [&](Face f) {
    ++total.faces;
    std::size_t& piece = piece_of[pieces.find(index(mesh.from_vertex_handle(mesh.halfedge_handle(f))))];
    if (piece == mesh.n_vertices()) {
      piece = total.per_component.size();
      total.per_component.push_back({.first_face = static_cast<std::size_t>(f.idx())});
    }
    ++total.per_component[piece].faces;
  });
  std::vector<bool> on_known_curve(mesh.n_halfedges(), false);
  for_each_edge(mesh, [&](OpenMesh::EdgeHandle e) {
    ++total.edges;
    ++piece_at(mesh.halfedge_handle(e, 0)).edges;
  });
  for_each_halfedge(mesh, [&](Halfedge first) {
    if (!mesh.is_boundary(first) || on_known_curve[index(first)]) return;
    ++total.boundary_curves;
    ++piece_at(first).boundary_curves;
    for (Halfedge h = first; !on_known_curve[index(h)]; h = mesh.next_halfedge_handle(h))
      on_known_curve[index(h)] = true;
  });

  // As a space: vertices on one point are one.
  std::size_t points = mesh.n_vertices();
  for (const std::uint32_t p : point_of_vertex) points = std::max<std::size_t>(points, p + std::size_t{1});
  DisjointSets space(points);
  std::vector<std::uint8_t> fans(points, 0);
  std::vector<bool> seen(points, false);
  for_each_vertex(mesh, [&](Vertex v) {
    const std::uint32_t p = point_of(v);
    if (!seen[p]) ++total.vertices;
    seen[p] = true;
    if (mesh.is_isolated(v)) return;
    ++piece_at(mesh.halfedge_handle(v)).vertices;
    if (fans[p] == 1) ++total.pinches;
    fans[p] = std::min<std::uint8_t>(static_cast<std::uint8_t>(fans[p] + 1), 2);
    space.unite(p, point_of(Vertex(static_cast<int>(pieces.find(index(v))))));
  });
  for (std::uint32_t p = 0; p < points; ++p) {
    if (!seen[p]) continue;
    if (fans[p] == 0) ++total.isolated;
    if (space.find(p) == p) ++total.components;
  }
  total.solid_components = total.per_component.size();
  total.genus = 0;
  long closed = 0;
  for (const ComponentReport& piece : total.per_component) {
    *total.genus += *piece.genus();
    closed += piece.betti()[2];
  }
  const long b0 = static_cast<long>(total.components);
  total.betti = {b0, b0 + closed - total.euler(), closed};
  return total;
}

}  // namespace meshops

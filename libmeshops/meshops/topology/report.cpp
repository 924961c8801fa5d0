#include "meshops/topology/report.h"

#include <algorithm>
#include <map>

#include "meshops/core/contract.h"
#include "meshops/core/live.h"
#include "meshops/handle/separate_fans.h"
#include "meshops/topology/soup_sides.h"
#include "meshops/topology/z2_rank.h"

namespace meshops {
namespace {

using detail::FaceFault;
using detail::SoupSide;
using Edge = std::span<const SoupSide>;

class SoupReporter {
 public:
  explicit SoupReporter(const PolygonSoup& soup)
      : soup_(soup), faults_(detail::find_face_faults(soup)), sides_(soup, faults_) {}

  TopologyReport operator()() {
    find_pieces();
    count_fans();
    count_edges();
    count_points();
    total_.genus = 0;
    for (const ComponentReport& piece : total_.per_component) {
      total_.boundary_curves += piece.boundary_curves;
      if (total_.genus && piece.orientable && !cut_)
        *total_.genus += *piece.genus();
      else
        total_.genus.reset();
    }
    total_.solid_components = total_.per_component.size();
    const long b0 = static_cast<long>(total_.components), b2 = cycles_of_faces();
    total_.betti = {b0, b0 + b2 - total_.euler(), b2};
    return std::move(total_);
  }

 private:
  /// Pieces of surface, in the order of their first faces.
  void find_pieces() {
    std::vector<Edge> disagreeing;
    DisjointSets pieces = detail::pieces_of(soup_, sides_, [&](Edge edge) { disagreeing.push_back(edge); });
    piece_of_.resize(soup_.faces());
    for (std::uint32_t f = 0; f < soup_.faces(); ++f) {
      if (faults_.of[f] != FaceFault::none) continue;
      const std::uint32_t root = pieces.find(f);
      if (root == f) {
        piece_of_[f] = total_.per_component.size();
        total_.per_component.push_back({.first_face = f});
      }
      piece_of_[f] = piece_of_[root];
      ++total_.per_component[piece_of_[f]].faces;
      ++total_.faces;
    }
    for (const Edge edge : disagreeing) piece_at(edge[0]).orientable = false;
  }

  ComponentReport& piece_at(const SoupSide& side) { return total_.per_component[piece_of_[side.face]]; }

  /// Vertices of the pieces, curves and pinches.
  void count_fans() {
    DisjointSets fans = detail::fans_of(soup_, sides_, [](Edge edge) { return edge.size() == 2; });
    // Every open side joins the fans at its ends: two open sides meet in a fan, so that the sets are the curves.
    DisjointSets curves(soup_.corners.size());
    std::vector<bool> is_open(soup_.corners.size(), false);
    for (std::size_t e = 0; e < sides_.edges(); ++e) {
      const Edge edge = sides_.edge(e);
      if (edge.size() == 2) continue;
      for (const SoupSide& side : edge) {
        const std::uint32_t low = fans.find(sides_.corner_at_low(side)), high = fans.find(sides_.corner_at_high(side));
        curves.unite(low, high);
        is_open[low] = is_open[high] = true;
      }
    }
    // Pinches are fans that no edge joins, not even one at which the pieces end.
    DisjointSets joined = detail::fans_of(soup_, sides_, [](Edge) { return true; });
    std::vector<std::uint8_t> fans_at(soup_.points, 0);
    for_each_corner([&](std::uint32_t c, std::size_t f) {
      if (fans.find(c) == c) {
        ComponentReport& piece = total_.per_component[piece_of_[f]];
        ++piece.vertices;
        if (is_open[c] && curves.find(c) == c) ++piece.boundary_curves;
      }
      if (joined.find(c) == c) {
        std::uint8_t& at = fans_at[soup_.corners[c]];
        if (++at == 2) ++total_.pinches;
        at = std::min<std::uint8_t>(at, 2);
      }
    });
  }

  void count_edges() {
    for (std::size_t e = 0; e < sides_.edges(); ++e) {
      const Edge edge = sides_.edge(e);
      ++total_.edges;
      if (edge.size() == 2) {
        ++piece_at(edge[0]).edges;
        continue;
      }
      for (const SoupSide& side : edge) ++piece_at(side).edges;
      cut_ = cut_ || edge.size() > 2;
    }
  }

  void count_points() {
    DisjointSets connected(soup_.points);
    std::vector<bool> used(soup_.points, false);
    for_each_corner([&](std::uint32_t c, std::size_t f) {
      used[soup_.corners[c]] = true;
      connected.unite(soup_.corners[c], soup_.corners[soup_.begin[f]]);
    });
    total_.vertices = soup_.points;
    for (std::uint32_t p = 0; p < soup_.points; ++p) {
      if (!used[p]) ++total_.isolated;
      if (connected.find(p) == p) ++total_.components;
    }
  }

  /// The dimension of the sets of faces of which an even number meets in every edge. Faces on both sides of an edge of
  /// two are in such a set together or not at all, so that a set is one of pieces; a piece with an edge of its own
  /// alone is in none; every other edge is an equation.
  long cycles_of_faces() {
    detail::Z2Rank equations;
    std::vector<std::size_t> unknowns;
    for (std::size_t e = 0; e < sides_.edges(); ++e) {
      const Edge edge = sides_.edge(e);
      if (edge.size() == 2) continue;
      unknowns.clear();
      for (const SoupSide& side : edge) unknowns.push_back(piece_of_[side.face]);
      equations.add(unknowns);
    }
    return static_cast<long>(total_.per_component.size() - equations.rank());
  }

  template <typename Visit>
  void for_each_corner(Visit visit) const {
    for (std::size_t f = 0; f < soup_.faces(); ++f) {
      if (faults_.of[f] != FaceFault::none) continue;
      for (std::size_t c = soup_.begin[f]; c < soup_.begin[f + 1]; ++c) visit(static_cast<std::uint32_t>(c), f);
    }
  }

  const PolygonSoup& soup_;
  detail::FaceFaults faults_;
  detail::SoupSides sides_;
  std::vector<std::size_t> piece_of_;
  bool cut_ = false;  // more than two faces meet in an edge
  TopologyReport total_;
};

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

TopologyReport report(const PolygonSoup& soup) { return SoupReporter(soup)(); }

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

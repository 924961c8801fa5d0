// What: finds a short cycle of edges around a tunnel.
// Law:  let the last edge, in the filtration, of a cycle make a tunnel, and let the cycle be a boundary of triangles up
//       to the triangle that ends the tunnel. The cycle is then no boundary of earlier triangles alone: otherwise an
//       earlier triangle would be paired with the edge.
// How:  the column of the reduction is a cycle of this kind. The shortest of all cycles with the given last edge
//       consists of the edge and a shortest path of earlier edges between its ends; columns decide whether this cycle
//       is a boundary when the tunnel ends. If not, shortest paths replace parts of the column's cycle where part and
//       path together are a boundary.
// Cost: for each cycle, the number of edges in a ball as large as the cycle around the ends of its last edge; several
//       times this number if parts are replaced; also the column reductions of Tunnels::is_boundary(), once for each
//       loop, path and replaced part. The constructor: linear in the edges.
// Source: Dijkstra (1959) and Hart, Nilsson, Raphael (1968): shortest paths.
//         docs/explanation/filtration_and_persistence.md, section 12.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/pairing/pairing.h"
#include "rbpa/space/persistence/solid_filtration.h"

namespace rbpa::space {

/// A cycle around a tunnel, of one or several loops.
struct Cycle {
  /// The edges of the loop that begins with the edge that makes the tunnel, in order; then those of further loops.
  std::vector<std::uint32_t> edges;
  double length = 0;         ///< sum of the lengths of the edges, in units of the points, with rounding errors
  bool is_shortest = false;  ///< whether it is known that no cycle of `Law` is shorter, up to rounding
};

class Cycles {
 public:
  /// Keeps references to all arguments.
  Cycles(std::span<const Point3> points, const SolidFiltration& filtration, Pairing& pairing, Steps& step);

  /// Returns a short cycle around the tunnel that `edge` makes. Requires: `edge` makes a tunnel, and a triangle
  /// ends it. Throws Cancelled.
  Cycle of(std::uint32_t edge);

 private:
  using Edges = std::vector<std::uint32_t>;
  struct Arc {
    std::uint32_t to, edge;
  };
  struct Loops {
    Edges first;                ///< the loop of the wanted edge, which is its first edge
    std::vector<Edges> others;  ///< the other loops: no common edge; no loop visits a point twice
  };

  double length(std::uint32_t edge) const;
  double length(std::span<const std::uint32_t> edges) const;
  std::uint32_t across(std::uint32_t edge, std::uint32_t point) const;
  Edges with_joining_edges(const Edges& others) const;
  Loops loops(const Edges& edges, std::uint32_t first) const;
  void drop_boundaries(Loops& loops, std::uint32_t triangle);
  std::optional<Edges> shorter_path(std::uint32_t from, std::uint32_t to, std::uint32_t before, double bound);
  Edges shortened(const Edges& loop, std::uint32_t triangle);

  std::span<const Point3> points_;
  const SolidFiltration& filtration_;
  Pairing& pairing_;
  Steps& step_;
  std::vector<std::size_t> begin_;  // for each point: the index of its first arc in arcs_
  std::vector<Arc> arcs_;
  std::vector<std::uint32_t> parent_edge_, depth_;  // for each point, in the tree of edges that end components
};

}  // namespace rbpa::space

// What: short cycles of edges, one for each tunnel.
// Law:  a cycle whose last edge in the filtration is the one that makes a tunnel, and which is a boundary of triangles up to the one that ends it, becomes a boundary
//       exactly then: had it been one before, that edge would have been paired before.
// How:  the column of the reduction is such a cycle. The shortest of all cycles with that edge as the last one is the edge and a shortest path between its ends
//       among edges before it; whether it is a boundary in time, columns decide. If it is not, parts of the column's cycle are replaced by shortest paths
//       where the difference is a boundary.
// Cost: of each, as many edges as a ball around its ends has that is as large as the cycle; where parts are replaced, some times the number of its edges.
// Source: Dijkstra (1959); Hart, Nilsson, Raphael (1968).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/base/steps.h"
#include "rbpa/solid_filtration.h"
#include "rbpa/space/persistence/pairing.h"

namespace rbpa::space {

struct Cycle {
  std::vector<std::uint32_t> edges;  ///< one after the other; from the one that makes the tunnel on
  double length = 0;
  bool is_shortest = false;
};

class Cycles {
 public:
  /// Keeps references.
  Cycles(std::span<const Point3> points, const SolidFiltration& filtration, Pairing& pairing, Steps& step);

  /// Of the tunnel that an edge makes. Requires: it makes one.
  Cycle of(std::uint32_t edge);

 private:
  using Edges = std::vector<std::uint32_t>;
  struct Arc {
    std::uint32_t to, edge;
  };
  struct Loops {
    Edges first;                ///< with the edge that was asked for, from there on
    std::vector<Edges> others;  ///< edge-disjoint, and no two edges of one more than once at a point
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
  std::vector<std::size_t> begin_;  // of each point's arcs
  std::vector<Arc> arcs_;
  std::vector<std::uint32_t> parent_edge_, depth_;  // of each point, in the tree of the edges that end components
};

}  // namespace rbpa::space

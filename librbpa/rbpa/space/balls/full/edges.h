// What: visits the edges of a triangulation of points or of a periodic box, each with the tetrahedra around the edge.
// Law:  an edge is identified by its two points, and in a periodic box also by the offset between them in boxes.
// Cost: linear, and a sort of the edges at each point.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/arrays/simplices_at.h"
#include "rbpa/base/parallel/in_order.h"
#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/run/checkpoint_of_threads.h"
#include "rbpa/space/balls/full/triangulated.h"

namespace rbpa::space {

/// An edge of a tetrahedron, between its corners `from` and `to`.
struct EdgeAt {
  std::uint32_t tetrahedron;
  std::uint8_t from, to;
};

/// Returns the numbers, from 0 to 3, of the two corners of the tetrahedron that are not ends of the edge.
inline std::array<std::size_t, 2> others(const EdgeAt& at) {
  std::array<std::size_t, 2> found{};
  for (std::size_t k = 0, count = 0; k < 4; ++k)
    if (k != at.from && k != at.to) found[count++] = k;
  return found;
}

/// Returns whether the least sphere through the ends of an edge has a radius of at most alpha and no corner of the
/// tetrahedra around the edge inside. `ring` has these tetrahedra.
bool is_edge_alone(const Triangulated& delaunay, std::span<const EdgeAt> ring, double alpha);

/// The tetrahedra at each point, as an array of lists.
class PointStars {
 public:
  explicit PointStars(const Triangulated& delaunay) {
    if (!delaunay.vertices.empty())
      for (auto row : delaunay.simplices) {
        for (std::uint32_t& corner : row) corner = delaunay.point(corner);
        by_points_.push_back(row);
      }
    const std::span<const std::array<std::uint32_t, 4>> rows = by_points_.empty() ? delaunay.simplices : by_points_;
    bound_ = corner_bound<4>(rows);
    at_ = TetrahedraAt(rows, bound_);
  }

  std::span<const std::uint32_t> operator[](std::size_t point) const { return at_[point]; }
  /// Returns one more than the greatest point.
  std::size_t bound() const { return bound_; }

 private:
  std::vector<std::array<std::uint32_t, 4>> by_points_;  // corners as points, in a periodic box only
  std::size_t bound_ = 0;
  TetrahedraAt at_;
};

/// Reusable memory of for_each_edge_up(): the edges at a point, and a hash table of them.
struct EdgesUp {
  struct Edge {
    std::uint64_t key;  // the point at the other end, and its offset in boxes from the given point
    std::uint32_t end;  // end of the edge's tetrahedra in `rings`; earlier, their number
  };
  std::vector<std::uint32_t> table, edge_of, order;  // edge_of: for each entry of `found`
  std::vector<Edge> edges;
  std::vector<EdgeAt> found, rings;

  static constexpr std::uint32_t none = 0xffffffff;
  /// Returns the number of the edge with this key. Adds the edge if there is none.
  std::uint32_t number(std::uint64_t key) {
    std::size_t at = (key * 0x9E3779B97F4A7C15U >> 32U) * table.size() >> 32U;
    while (table[at] != none && edges[table[at]].key != key) at = (at + 1) & (table.size() - 1);
    if (table[at] == none) {
      table[at] = static_cast<std::uint32_t>(edges.size());
      edges.push_back({key, 0});
    }
    return table[at];
  }
};

/// Calls visit(b, tetrahedra around the edge) for each edge from a to a point b > a, ascending by b. The tetrahedra
/// ascend. Cost: linear, and a sort of the edges.
template <typename Visit>
void for_each_edge_up(std::uint32_t a, std::span<const std::uint32_t> star, const Triangulated& delaunay, EdgesUp& up,
                      Visit visit) {
  up.table.assign(std::bit_ceil(6 * star.size() + 1), EdgesUp::none);
  up.edges.clear();
  up.edge_of.clear();
  up.found.clear();
  for (const std::uint32_t t : star) {
    const auto& row = delaunay.simplices[t];
    std::uint8_t from = 0;
    while (delaunay.point(row[from]) != a) ++from;
    for (std::uint8_t to = 0; to < 4; ++to) {
      const std::uint32_t b = delaunay.point(row[to]);
      if (b <= a) continue;
      std::uint64_t key = std::uint64_t{b} << 32U;
      if (!delaunay.vertices.empty())
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const auto apart = delaunay.vertices[row[to]].offset[axis] - delaunay.vertices[row[from]].offset[axis];
          key |= static_cast<std::uint64_t>(apart + 128) << (16 - 8 * axis);
        }
      up.edge_of.push_back(up.number(key));
      ++up.edges[up.edge_of.back()].end;
      up.found.push_back({t, from, to});
    }
  }
  up.order.resize(up.edges.size());
  std::iota(up.order.begin(), up.order.end(), 0U);
  std::sort(up.order.begin(), up.order.end(),
            [&](std::uint32_t i, std::uint32_t j) { return up.edges[i].key < up.edges[j].key; });
  std::uint32_t begin = 0;
  for (EdgesUp::Edge& edge : up.edges) edge.end = std::exchange(begin, begin + edge.end);
  up.rings.resize(up.found.size());
  for (std::size_t i = 0; i < up.found.size(); ++i) up.rings[up.edges[up.edge_of[i]].end++] = up.found[i];
  for (const std::uint32_t i : up.order) {
    const std::uint32_t first = i == 0 ? 0 : up.edges[i - 1].end;
    visit(static_cast<std::uint32_t>(up.edges[i].key >> 32U),
          std::span<const EdgeAt>(up.rings).subspan(first, up.edges[i].end - first));
  }
}

/// Calls is_meant(a, b, tetrahedra around the edge) for each edge with a < b, from any thread. Calls join(a, b), one
/// call at a time and in order, for each edge for which is_meant() returned true. Throws: Cancelled.
template <typename IsMeant, typename Join>
void for_each_edge(const Triangulated& delaunay, const PointStars& stars, Threads& threads, const IsMeant& is_meant,
                   const Join& join, const GoOn& go_on = {}) {
  constexpr std::size_t points_at_a_time = 1u << 10;
  struct Workspace {
    EdgesUp up;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  };
  CheckpointOfThreads checkpoint(go_on);
  in_order<Workspace>(
      threads, (stars.bound() + points_at_a_time - 1) / points_at_a_time,
      [&](std::size_t part, Workspace& w) {
        checkpoint();
        w.edges.clear();
        const std::size_t end = std::min((part + 1) * points_at_a_time, stars.bound());
        for (auto a = static_cast<std::uint32_t>(part * points_at_a_time); a < end; ++a)
          for_each_edge_up(a, stars[a], delaunay, w.up, [&](std::uint32_t b, std::span<const EdgeAt> ring) {
            if (is_meant(a, b, ring)) w.edges.emplace_back(a, b);
          });
      },
      [&](std::size_t, Workspace& w) {
        for (const auto& edge : w.edges) join(edge.first, edge.second);
      },
      [](std::size_t, Workspace&) {});
}

struct EdgeCounts {
  std::size_t edges = 0;
  std::size_t points = 0;  ///< number of points that are ends of an edge
  std::size_t joined = 0;  ///< number of edges of a spanning forest; points − joined is the number of components
};

/// Counts the edges for which has_edge(tetrahedra around the edge) returns true. Any thread calls has_edge().
template <typename HasEdge>
EdgeCounts count_edges(const Triangulated& delaunay, Threads& threads, const HasEdge& has_edge,
                       const GoOn& go_on = {}) {
  const PointStars stars(delaunay);
  meshops::DisjointSets sets(stars.bound());
  std::vector<bool> is_end(stars.bound(), false);
  EdgeCounts counts;
  for_each_edge(
      delaunay, stars, threads,
      [&](std::uint32_t, std::uint32_t, std::span<const EdgeAt> ring) { return has_edge(ring); },
      [&](std::uint32_t a, std::uint32_t b) {
        ++counts.edges;
        for (const std::uint32_t end : {a, b}) {
          counts.points += is_end[end] ? 0u : 1u;
          is_end[end] = true;
        }
        counts.joined += sets.join(a, b) ? 1u : 0u;
      },
      go_on);
  return counts;
}

}  // namespace rbpa::space

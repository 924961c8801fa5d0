// What: visits the edges of a triangulation, of points or of a periodic box, each with the tetrahedra around it.
// Law:  an edge is identified by its points, and in a periodic box also by their offset in boxes.
// Cost: a sort of the edges at each point.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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

/// Returns the numbers of the other two corners of the tetrahedron.
inline std::array<std::size_t, 2> others(const EdgeAt& at) {
  std::array<std::size_t, 2> found{};
  for (std::size_t k = 0, count = 0; k < 4; ++k)
    if (k != at.from && k != at.to) found[count++] = k;
  return found;
}

/// Returns whether the least sphere through the ends of an edge has a radius of at most alpha and contains no corner of
/// the tetrahedra around the edge, `ring`.
bool is_edge_alone(const Triangulated& delaunay, std::span<const EdgeAt> ring, double alpha);

/// The tetrahedra at each point.
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

/// An edge at a given point, in one of its tetrahedra: the point at its other end, and the offset of that end.
struct EdgeEnd {
  std::uint32_t point;
  std::array<std::int8_t, 3> apart;  // offset of the point from the given one, in boxes
  EdgeAt at;

  bool is_same(const EdgeEnd& other) const { return point == other.point && apart == other.apart; }
  bool operator<(const EdgeEnd& other) const {
    if (point != other.point) return point < other.point;
    return apart != other.apart ? apart < other.apart : at.tetrahedron < other.at.tetrahedron;
  }
};

/// Calls visit(b, tetrahedra around the edge from a to b) for each edge at a whose other end b is greater, ascending by
/// b. `ends` is reusable memory.
template <typename Visit>
void for_each_edge_up(std::uint32_t a, std::span<const std::uint32_t> star, const Triangulated& delaunay,
                      std::vector<EdgeEnd>& ends, Visit visit) {
  ends.clear();
  for (const std::uint32_t t : star) {
    const auto& row = delaunay.simplices[t];
    std::uint8_t from = 0;
    while (delaunay.point(row[from]) != a) ++from;
    for (std::uint8_t to = 0; to < 4; ++to) {
      const std::uint32_t b = delaunay.point(row[to]);
      if (b <= a) continue;
      EdgeEnd end{b, {0, 0, 0}, {t, from, to}};
      if (!delaunay.vertices.empty())
        for (std::size_t axis = 0; axis < 3; ++axis)
          end.apart[axis] = static_cast<std::int8_t>(delaunay.vertices[row[to]].offset[axis] -
                                                     delaunay.vertices[row[from]].offset[axis]);
      ends.push_back(end);
    }
  }
  std::sort(ends.begin(), ends.end());
  std::vector<EdgeAt> ring;
  for (std::size_t first = 0; first < ends.size();) {
    ring.clear();
    std::size_t last = first;
    for (; last < ends.size() && ends[last].is_same(ends[first]); ++last) ring.push_back(ends[last].at);
    visit(ends[first].point, std::span<const EdgeAt>(ring));
    first = last;
  }
}

/// Calls is_meant(a, b, tetrahedra around the edge) for each edge, a < b, from any thread; then join(a, b), one call at
/// a time and in order, for each edge for which is_meant returned true. Throws: Cancelled.
template <typename IsMeant, typename Join>
void for_each_edge(const Triangulated& delaunay, const PointStars& stars, Threads& threads, const IsMeant& is_meant,
                   const Join& join, const GoOn& go_on = {}) {
  constexpr std::size_t points_at_a_time = 1u << 10;
  struct Workspace {
    std::vector<EdgeEnd> ends;
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
          for_each_edge_up(a, stars[a], delaunay, w.ends, [&](std::uint32_t b, std::span<const EdgeAt> ring) {
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
  std::size_t joined = 0;  ///< edges of a spanning forest: points − joined = components
};

/// Counts the edges for which has_edge(tetrahedra around the edge) returns true; it is called from any thread.
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

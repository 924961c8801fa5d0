#include "rbpa/space/normals/sides/side_confidence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "rbpa/space/normals/sides/compare_normals.h"

namespace rbpa::space {
namespace {

using Number = std::uint32_t;

/// The tree, cut into paths. Each path leads from a vertex to the child with the most vertices below, so that few paths
/// connect any vertex with the root. Vertices are named by their ranks, in which parents come before children.
class TreePaths {
 public:
  explicit TreePaths(const OrientationTree& tree)
      : rank_(tree.parent.size()),
        parent_(rank_.size()),
        head_(rank_.size()),
        below_(rank_.size(), 1),
        heavy_(rank_.size(), 0) {
    const auto size = static_cast<Number>(tree.order.size());
    for (Number r = 0; r < size; ++r) rank_[tree.order[r]] = r;
    for (Number r = 0; r < size; ++r) parent_[r] = rank_[tree.parent[tree.order[r]]];
    for (Number r = size; r-- > 1;) below_[parent_[r]] += below_[r];
    for (Number r = size; r-- > 1;)
      if (Number& best = heavy_[parent_[r]]; best == 0 || below_[r] >= below_[best]) best = r;
    for (Number r = 1; r < size; ++r) head_[r] = heavy_[parent_[r]] == r ? head_[parent_[r]] : r;
    below_[0] = 0;
  }

  Number rank(Number vertex) const { return rank_[vertex]; }
  Number parent(Number r) const { return parent_[r]; }
  /// Returns the number of vertices below r, r included. Returns 0 for the root, whose number stands for no child.
  Number below(Number r) const { return below_[r]; }
  /// Returns the child with the most vertices below; 0 if there is none.
  Number heavy(Number r) const { return heavy_[r]; }

  /// Returns the lowest vertex above both. Of two different heads, the later one is not above the other vertex.
  Number above(Number r, Number s) const {
    while (head_[r] != head_[s])
      if (head_[r] > head_[s])
        r = parent_[head_[r]];
      else
        s = parent_[head_[s]];
    return std::min(r, s);
  }

 private:
  std::vector<Number> rank_, parent_, head_, below_, heavy_;
};

/// Votes as integers, so that adding and subtracting a vote leaves exactly 0.
struct Votes {
  std::int64_t sum = 0, all = 0;  ///< sums of the votes with signs, and without
  void add(std::int64_t vote, std::int64_t times) {
    sum += times * vote;
    all += times * std::abs(vote);
  }
  double agreement() const { return all == 0 ? 0 : std::max(0.0, static_cast<double>(sum) / static_cast<double>(all)); }
};

}  // namespace

template <typename Real>
std::vector<double> side_confidence(const Neighborhoods& near, std::span<const Point3> normals,
                                    const OrientationTree& tree, const OuterSides& sides, const Checkpoint& go_on) {
  constexpr double one = 1 << 20;
  constexpr Number points_at_a_time = 4096;
  const auto size = static_cast<Number>(near.points.size());
  const TreePaths paths(tree);
  std::vector<Votes> below(
      // By rank: votes of edges with an end in the subtree, minus twice those of edges with both ends in it
      size + std::size_t{1});
  for (Number i = 0; i < size; ++i) {
    if (go_on && i % points_at_a_time == 0) go_on();
    for (const Number j : near.around(i)) {
      const auto back = near.around(j);
      if (j < i && std::find(back.begin(), back.end(), i) != back.end()) continue;  // each edge once
      const NormalComparison c = compare_normals<Real>(near.points[i], normals[i], near.points[j], normals[j]);
      const double weight = std::max(0.0, std::abs(c.agreement) - c.tilt);
      const auto vote = static_cast<std::int64_t>(std::lround(one * std::copysign(weight, c.agreement)));
      const Number r = paths.rank(i), s = paths.rank(j);
      below[r].add(vote, 1);
      below[s].add(vote, 1);
      below[paths.above(r, s)].add(vote, -2);
    }
  }
  for (Number r = size; r > 0; --r) {
    Votes& up = below[paths.parent(r)];
    up.sum += below[r].sum;
    up.all += below[r].all;
  }
  // The confidence of each vertex, starting from the middle of its part of the tree.
  std::vector<double> by_rank(size + std::size_t{1}, -1), confidence(size);
  for (Number r = 1; r <= size; ++r)
    if (paths.parent(r) == 0) {
      Number middle = r;
      while (2 * paths.below(paths.heavy(middle)) > paths.below(r)) middle = paths.heavy(middle);
      const Number seed = tree.order[r];
      by_rank[middle] = sides.empty() || sides.side[seed] == 0 ? 1 : sides.vote[seed];
      for (Number up = middle; up != r; up = paths.parent(up))
        by_rank[paths.parent(up)] = std::min(by_rank[up], below[up].agreement());
    }
  for (Number r = 1; r <= size; ++r) {
    if (by_rank[r] < 0) by_rank[r] = std::min(by_rank[paths.parent(r)], below[r].agreement());
    confidence[tree.order[r]] = by_rank[r];
  }
  return confidence;
}

template std::vector<double> side_confidence<double>(const Neighborhoods&, std::span<const Point3>,
                                                     const OrientationTree&, const OuterSides&, const Checkpoint&);
template std::vector<double> side_confidence<long double>(const Neighborhoods&, std::span<const Point3>,
                                                          const OrientationTree&, const OuterSides&, const Checkpoint&);

}  // namespace rbpa::space

#include "rbpa/space/persistence/tunnels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "rbpa/solid.h"

namespace rbpa::space {
namespace {

constexpr std::uint32_t none = Solid::none;

/// A sum of columns: a heap of ranks, of which those that come twice are not there.
class Column {
 public:
  void clear() { ranks_.clear(); }
  void add(std::uint32_t rank) {
    ranks_.push_back(rank);
    std::push_heap(ranks_.begin(), ranks_.end());
  }
  /// The greatest, or none.
  std::uint32_t pivot() {
    while (!ranks_.empty()) {
      const std::uint32_t greatest = pop();
      if (ranks_.empty() || ranks_.front() != greatest) {
        add(greatest);
        return greatest;
      }
      pop();
    }
    return none;
  }
  /// All, in any order; then it is empty.
  std::vector<std::uint32_t> release() {
    std::sort(ranks_.begin(), ranks_.end());
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < ranks_.size();) {
      std::size_t end = i + 1;
      while (end < ranks_.size() && ranks_[end] == ranks_[i]) ++end;
      if ((end - i) % 2 == 1) kept.push_back(ranks_[i]);
      i = end;
    }
    ranks_.clear();
    return kept;
  }

 private:
  std::uint32_t pop() {
    std::pop_heap(ranks_.begin(), ranks_.end());
    const std::uint32_t greatest = ranks_.back();
    ranks_.pop_back();
    return greatest;
  }

  std::vector<std::uint32_t> ranks_;
};

class Reduction {
 public:
  Reduction(const SolidFiltration& filtration, std::span<const std::uint32_t> order, const std::vector<bool>& joins)
      : filtration_(filtration), rank_(order.size()), owner_(order.size(), none), kept_(order.size(), none) {
    for (std::uint32_t rank = 0; rank < order.size(); ++rank) rank_[order[rank]] = joins[order[rank]] ? none : rank;
    for (const auto& edge : filtration.edges) {
      if (edge[0] + std::size_t{2} > begin_.size()) begin_.resize(edge[0] + std::size_t{2}, 0);
      ++begin_[edge[0] + std::size_t{1}];
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  }

  void reduce(std::uint32_t triangle) {
    column_.clear();
    add_boundary(triangle);
    bool is_sum = false;
    while (true) {
      const std::uint32_t pivot = column_.pivot();
      if (pivot == none) return;  // of no triangle that ends a tunnel
      if (owner_[pivot] == none) return keep(pivot, triangle, is_sum);
      if (is_before(triangle, owner_[pivot])) {
        // What was reduced goes there; what was there goes on.
        const std::uint32_t other = owner_[pivot];
        const std::vector<std::uint32_t> others = released(pivot);
        keep(pivot, triangle, is_sum);
        triangle = other;
        if (others.empty())
          add_boundary(triangle);
        else
          for (const std::uint32_t rank : others) column_.add(rank);
      }
      add_column(pivot);
      is_sum = true;
    }
  }

  std::uint32_t owner(std::uint32_t rank) const { return owner_[rank]; }

 private:
  bool is_before(std::uint32_t a, std::uint32_t b) const {
    const double of_a = filtration_.triangle_alpha[a], of_b = filtration_.triangle_alpha[b];
    return of_a != of_b ? of_a < of_b : a < b;
  }

  std::uint32_t rank_of(std::uint32_t a, std::uint32_t b) const {
    const auto first = filtration_.edges.begin() + static_cast<std::ptrdiff_t>(begin_[a]),
               last = filtration_.edges.begin() + static_cast<std::ptrdiff_t>(begin_[a + std::size_t{1}]);
    const auto at = std::lower_bound(first, last, b, [](const auto& edge, std::uint32_t end) { return edge[1] < end; });
    return rank_[static_cast<std::size_t>(at - filtration_.edges.begin())];
  }
  void add_boundary(std::uint32_t triangle) {
    const auto& [a, b, c] = filtration_.triangles[triangle];
    for (const std::uint32_t rank : {rank_of(a, b), rank_of(a, c), rank_of(b, c)})
      if (rank != none) column_.add(rank);
  }
  void add_column(std::uint32_t pivot) {
    if (kept_[pivot] == none) return add_boundary(owner_[pivot]);
    for (const std::uint32_t rank : columns_[kept_[pivot]]) column_.add(rank);
  }

  void keep(std::uint32_t pivot, std::uint32_t triangle, bool is_sum) {
    owner_[pivot] = triangle;
    if (!is_sum) return column_.clear();
    if (free_.empty()) {
      free_.push_back(static_cast<std::uint32_t>(columns_.size()));
      columns_.emplace_back();
    }
    kept_[pivot] = free_.back();
    free_.pop_back();
    columns_[kept_[pivot]] = column_.release();
  }
  /// The sum that is kept there, if any; then none is.
  std::vector<std::uint32_t> released(std::uint32_t pivot) {
    const std::uint32_t at = std::exchange(kept_[pivot], none);
    if (at == none) return {};
    free_.push_back(at);
    return std::exchange(columns_[at], {});
  }

  const SolidFiltration& filtration_;
  std::vector<std::uint32_t> rank_;   // of each edge, or none where it ends a component
  std::vector<std::size_t> begin_;    // of the edges of each point that is their first
  std::vector<std::uint32_t> owner_;  // of each rank that is a pivot: the triangle
  std::vector<std::uint32_t> kept_;   // of each such rank: which of the columns, or none: the triangle's boundary
  std::vector<std::vector<std::uint32_t>> columns_;
  std::vector<std::uint32_t> free_;
  Column column_;
};

}  // namespace

std::vector<std::uint32_t> pair_tunnels(const SolidFiltration& filtration, std::span<const std::uint32_t> order,
                                        const std::vector<bool>& joins, const std::vector<std::uint32_t>& ended,
                                        Steps& step) {
  Reduction reduction(filtration, order, joins);
  for (const std::uint32_t triangle : ended) {
    step(16);
    reduction.reduce(triangle);
  }
  std::vector<std::uint32_t> result(order.size());
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) result[order[rank]] = reduction.owner(rank);
  return result;
}

}  // namespace rbpa::space

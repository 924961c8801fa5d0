#include "rbpa/space/persistence/tunnels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

#include "rbpa/solid.h"

namespace rbpa::space {
namespace {

constexpr std::uint32_t none = Solid::none;

/// An edge in a column: its rank in the filtration, from 1 on, above its number; so they are compared by rank. 0 is none.
using Entry = std::uint64_t;
std::uint32_t edge_of(Entry entry) { return static_cast<std::uint32_t>(entry); }

/// A sum of columns: ascending entries; where there are many, a heap, of which those that come twice are not there.
class Column {
 public:
  void clear() {
    entries_.clear();
    is_heap_ = false;
  }
  void assign(std::span<const Entry> ascending) {
    entries_.assign(ascending.begin(), ascending.end());
    is_heap_ = false;
  }
  void add(std::span<const Entry> ascending) {
    constexpr std::size_t few = 64;
    if (!is_heap_ && entries_.size() + ascending.size() > few) {
      is_heap_ = true;
      std::make_heap(entries_.begin(), entries_.end());
    }
    if (is_heap_) {
      for (const Entry entry : ascending) push(entry);
      return;
    }
    sum_.clear();
    std::set_symmetric_difference(entries_.begin(), entries_.end(), ascending.begin(), ascending.end(),
                                  std::back_inserter(sum_));
    entries_.swap(sum_);
  }
  /// The greatest, or 0.
  Entry pivot() {
    if (!is_heap_) return entries_.empty() ? 0 : entries_.back();
    while (!entries_.empty()) {
      const Entry greatest = pop();
      if (entries_.empty() || entries_.front() != greatest) {
        push(greatest);
        return greatest;
      }
      pop();
    }
    return 0;
  }
  /// All, ascending.
  std::vector<Entry> ascending() {
    if (!is_heap_) return {entries_.begin(), entries_.end()};
    std::sort(entries_.begin(), entries_.end());
    std::vector<Entry> kept;
    for (std::size_t i = 0; i < entries_.size();) {
      std::size_t end = i + 1;
      while (end < entries_.size() && entries_[end] == entries_[i]) ++end;
      if ((end - i) % 2 == 1) kept.push_back(entries_[i]);
      i = end;
    }
    return kept;
  }

 private:
  void push(Entry entry) {
    entries_.push_back(entry);
    std::push_heap(entries_.begin(), entries_.end());
  }
  Entry pop() {
    std::pop_heap(entries_.begin(), entries_.end());
    const Entry greatest = entries_.back();
    entries_.pop_back();
    return greatest;
  }

  std::vector<Entry> entries_, sum_;
  bool is_heap_ = false;
};

class Reduction {
 public:
  Reduction(const SolidFiltration& filtration, std::span<const std::uint32_t> order, const std::vector<bool>& joins)
      : filtration_(filtration), entry_(order.size()), owner_(order.size(), none), kept_(order.size(), none) {
    for (std::uint32_t rank = 0; rank < order.size(); ++rank)
      entry_[order[rank]] = joins[order[rank]] ? 0 : (rank + Entry{1}) << 32U | order[rank];
  }

  void reduce(std::uint32_t triangle) {
    const Boundary boundary = boundary_of(triangle);
    Entry pivot = boundary.entries.back();
    if (pivot == 0) return;
    if (owner_[edge_of(pivot)] == none) {
      owner_[edge_of(pivot)] = triangle;
      return;
    }
    column_.assign(boundary.span());
    bool is_sum = false;
    for (; pivot != 0; pivot = column_.pivot()) {
      const std::uint32_t edge = edge_of(pivot), owner = owner_[edge];
      if (owner == none) return keep(edge, triangle, is_sum);
      if (is_before(triangle, owner)) {
        // What was reduced goes there; what was there goes on.
        const std::vector<Entry> others = released(edge);
        std::vector<Entry> mine = column_.ascending();
        if (others.empty())
          column_.assign(boundary_of(owner).span());
        else
          column_.assign(others);
        column_.add(mine);
        keep(edge, triangle, is_sum, std::move(mine));
        triangle = owner;
      } else if (kept_[edge] == none) {
        column_.add(boundary_of(owner).span());
      } else {
        column_.add(columns_[kept_[edge]]);
      }
      is_sum = true;
    }
  }

  std::vector<std::uint32_t> release_owners() { return std::move(owner_); }

 private:
  struct Boundary {
    std::array<Entry, 3> entries;  ///< ascending; zeros are none
    std::span<const Entry> span() const {
      return std::span(entries).subspan(static_cast<std::size_t>(std::count(entries.begin(), entries.end(), Entry{0})));
    }
  };

  Boundary boundary_of(std::uint32_t triangle) const {
    const auto& [a, b, c] = filtration_.edges_of[triangle];
    Boundary boundary{{entry_[a], entry_[b], entry_[c]}};
    std::sort(boundary.entries.begin(), boundary.entries.end());
    return boundary;
  }
  bool is_before(std::uint32_t a, std::uint32_t b) const {
    const double of_a = filtration_.triangle_alpha[a], of_b = filtration_.triangle_alpha[b];
    return of_a != of_b ? of_a < of_b : a < b;
  }

  void keep(std::uint32_t edge, std::uint32_t triangle, bool is_sum) {
    keep(edge, triangle, is_sum, is_sum ? column_.ascending() : std::vector<Entry>());
  }
  void keep(std::uint32_t edge, std::uint32_t triangle, bool is_sum, std::vector<Entry> column) {
    owner_[edge] = triangle;
    if (!is_sum) return;
    if (free_.empty()) {
      free_.push_back(static_cast<std::uint32_t>(columns_.size()));
      columns_.emplace_back();
    }
    kept_[edge] = free_.back();
    free_.pop_back();
    columns_[kept_[edge]] = std::move(column);
  }
  /// The sum that is kept there, if any; then none is.
  std::vector<Entry> released(std::uint32_t edge) {
    const std::uint32_t at = std::exchange(kept_[edge], none);
    if (at == none) return {};
    free_.push_back(at);
    return std::exchange(columns_[at], {});
  }

  const SolidFiltration& filtration_;
  std::vector<Entry> entry_;          // of each edge; 0 where it ends a component
  std::vector<std::uint32_t> owner_;  // of each edge that is a pivot: the triangle
  std::vector<std::uint32_t> kept_;   // of each such edge: which of the columns, or none: the triangle's boundary
  std::vector<std::vector<Entry>> columns_;
  std::vector<std::uint32_t> free_;
  Column column_;
};

}  // namespace

std::vector<std::uint32_t> pair_tunnels(const SolidFiltration& filtration, std::span<const std::uint32_t> order,
                                        const std::vector<bool>& joins, const std::vector<bool>& makes_void,
                                        Steps& step) {
  Reduction reduction(filtration, order, joins);
  for (std::uint32_t triangle = 0; triangle < filtration.triangles.size(); ++triangle) {
    step(makes_void[triangle] ? 1 : 8);
    if (!makes_void[triangle]) reduction.reduce(triangle);
  }
  return reduction.release_owners();
}

}  // namespace rbpa::space

// What: finds the triangle that ends each tunnel, and a cycle that becomes a boundary with this triangle.
// How:  columns of the boundary matrix, with coefficients in Z/2, are reduced in the order in which triangles are
//       numbered, along a curve through space. If a column has the pivot of the stored column of a later triangle, the
//       column replaces the stored one, whose reduction continues. Memory is used only for columns that are sums of
//       several boundaries; any other column is the boundary of its triangle. Edges that end a component cannot be
//       pivots and are in no column: the other edges of a cycle determine the cycle.
// Law:  the pairs do not depend on the order of reduction, as the reduced matrix has the same pivots in any order. The
//       columns of the triangles up to a given triangle span the boundaries of these triangles.
// Cost: nearly linear in practice: most columns are never added to another.
// Source: de Silva, Morozov, Vejdemo-Johansson, Dualities in persistent (co)homology (2011); Bauer, Kerber,
//         Reininghaus, Clear and compress (2014).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include "rbpa/base/run/steps.h"
#include "rbpa/space/persistence/solid_filtration.h"

namespace rbpa::space {

/// An edge in a column. The high bits have the rank of the edge in the filtration, from 1, and the low bits its number,
/// so that a comparison of entries compares ranks. 0 stands for no entry.
using ColumnEntry = std::uint64_t;
inline ColumnEntry column_entry(std::uint32_t rank, std::uint32_t edge) { return ColumnEntry{rank} << 32U | edge; }
inline std::uint32_t edge_of(ColumnEntry entry) { return static_cast<std::uint32_t>(entry); }

/// A column of a boundary matrix with coefficients in Z/2, to which other columns are added. Few entries are a sorted
/// list, many are a heap, in which an entry that occurs an even number of times is absent.
class Column {
 public:
  /// Replaces all entries.
  void assign(std::span<const ColumnEntry> ascending) {
    entries_.assign(ascending.begin(), ascending.end());
    is_heap_ = false;
  }
  /// Adds a column modulo 2: entries that are in both columns are removed.
  void add(std::span<const ColumnEntry> ascending) {
    constexpr std::size_t few = 64;
    if (!is_heap_ && entries_.size() + ascending.size() > few) {
      is_heap_ = true;
      std::make_heap(entries_.begin(), entries_.end());
    }
    if (is_heap_) {
      for (const ColumnEntry entry : ascending) push(entry);
      return;
    }
    sum_.clear();
    std::set_symmetric_difference(entries_.begin(), entries_.end(), ascending.begin(), ascending.end(),
                                  std::back_inserter(sum_));
    entries_.swap(sum_);
  }
  /// Returns the greatest entry, or 0 if the column is empty.
  ColumnEntry pivot() {
    if (!is_heap_) return entries_.empty() ? 0 : entries_.back();
    while (!entries_.empty()) {
      const ColumnEntry greatest = pop();
      if (entries_.empty() || entries_.front() != greatest) {
        push(greatest);
        return greatest;
      }
      pop();
    }
    return 0;
  }
  /// Returns all entries, ascending. Afterwards the entries are unspecified until assign().
  std::vector<ColumnEntry> ascending() {
    if (!is_heap_) return {entries_.begin(), entries_.end()};
    std::sort(entries_.begin(), entries_.end());
    std::vector<ColumnEntry> kept;
    for (std::size_t i = 0; i < entries_.size();) {
      std::size_t end = i + 1;
      while (end < entries_.size() && entries_[end] == entries_[i]) ++end;
      if ((end - i) % 2 == 1) kept.push_back(entries_[i]);
      i = end;
    }
    return kept;
  }

 private:
  void push(ColumnEntry entry) {
    entries_.push_back(entry);
    std::push_heap(entries_.begin(), entries_.end());
  }
  ColumnEntry pop() {
    std::pop_heap(entries_.begin(), entries_.end());
    const ColumnEntry greatest = entries_.back();
    entries_.pop_back();
    return greatest;
  }

  std::vector<ColumnEntry> entries_, sum_;
  bool is_heap_ = false;
};

class Tunnels {
 public:
  /// Reduces the matrix. `order` has the edges sorted by alpha. Edges marked in `joins` make no tunnel; triangles
  /// marked in `makes_void` end no tunnel. Keeps a reference to `filtration`.
  Tunnels(const SolidFiltration& filtration, std::span<const std::uint32_t> order, const std::vector<bool>& joins,
          const std::vector<bool>& makes_void, Steps& step);

  /// Returns the triangle that ends the tunnel that an edge makes; Solid::none if there is no such tunnel or triangle.
  std::uint32_t ended_by(std::uint32_t edge) const { return owner_[edge]; }
  /// Returns ended_by() of each edge, and frees all other memory.
  std::vector<std::uint32_t> all_ended_by() && {
    Tunnels taken = std::move(*this);
    return std::move(taken.owner_);
  }
  /// Returns whether an edge comes before another in the filtration.
  bool is_before(std::uint32_t edge, std::uint32_t other) const { return rank_[edge] < rank_[other]; }
  /// Returns the edges, without those that end components, of a cycle around the tunnel that `edge` makes. The cycle
  /// becomes a boundary with the triangle ended_by(edge). Requires: ended_by(edge) is not Solid::none.
  std::vector<std::uint32_t> cycle(std::uint32_t edge) const;
  /// Returns whether the cycle `edges` is a boundary of triangles up to `triangle` in the filtration. Edges are added
  /// modulo 2: an edge that occurs twice in `edges` is not in the cycle.
  bool is_boundary(std::span<const std::uint32_t> edges, std::uint32_t triangle);

 private:
  struct Boundary;

  Boundary boundary_of(std::uint32_t triangle) const;
  bool is_triangle_before(std::uint32_t a, std::uint32_t b) const;
  void reduce(std::uint32_t triangle);
  void add_column_of(std::uint32_t edge);
  void keep(std::uint32_t edge, std::uint32_t triangle, std::vector<ColumnEntry> column);
  std::vector<ColumnEntry> released(std::uint32_t edge);

  const SolidFiltration& filtration_;
  std::vector<std::uint32_t> rank_;   // for each edge: its rank in the filtration, from 1
  std::vector<bool> joins_;           // for each edge: whether it ends a component
  std::vector<std::uint32_t> owner_;  // for each edge: the triangle of the column with this pivot, or none
  // For each edge: the index in columns_ of the column with this pivot; none if the column is the boundary of owner_.
  std::vector<std::uint32_t> kept_;
  std::vector<std::vector<ColumnEntry>> columns_;
  std::vector<std::uint32_t> free_;
  Column column_;
};

}  // namespace rbpa::space

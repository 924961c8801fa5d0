// What: stores a column of a boundary matrix with coefficients in Z/2, and adds other columns to it.
// How:  few entries are a sorted list, many are a heap, in which an entry that occurs an even number of times is
//       absent.
// Cost: linear in the entries added, times a logarithm in a heap.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

namespace rbpa::space {

/// An edge in a column. The high bits have the rank of the edge in the filtration, from 1, and the low bits its number,
/// so that a comparison of entries compares ranks. 0 stands for no entry.
using ColumnEntry = std::uint64_t;
inline ColumnEntry column_entry(std::uint32_t rank, std::uint32_t edge) { return ColumnEntry{rank} << 32U | edge; }
inline std::uint32_t edge_of(ColumnEntry entry) { return static_cast<std::uint32_t>(entry); }

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

}  // namespace rbpa::space

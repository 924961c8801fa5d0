// What:   union–find on the numbers 0 … n − 1.
// Cost:   practically constant per call (inverse Ackermann, amortised); one word per number.
// Source: Tarjan, van Leeuwen, Worst-case analysis of set union algorithms (1984): path halving, linking by size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace rbpa {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count, -1) {}

  /// The number that stands for the set of `i`.
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] >= 0) {
      const auto up = static_cast<std::uint32_t>(parent_[i]);
      if (parent_[up] < 0) return up;
      parent_[i] = parent_[up];
      i = static_cast<std::uint32_t>(parent_[up]);
    }
    return i;
  }

  /// Joins two different sets, given by the numbers that stand for them; returns the one that stands for both.
  std::uint32_t link(std::uint32_t a, std::uint32_t b) {
    if (parent_[a] > parent_[b]) std::swap(a, b);
    parent_[a] += parent_[b];
    parent_[b] = static_cast<std::int32_t>(a);
    return a;
  }

  /// Joins the sets of a and b; false when they are one already.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    link(a, b);
    return true;
  }

 private:
  std::vector<std::int32_t> parent_;  // of what stands for a set: minus its size
};

}  // namespace rbpa

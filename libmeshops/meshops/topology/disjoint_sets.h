// What: union–find over numbers from 0, with the parity of each number to the least of its set.
// Cost: amortised logarithmic, in practice constant.
#pragma once

#include <cstddef>
#include <cstdint>

#include "meshops/core/api.h"
#include "meshops/core/fresh_vector.h"

namespace meshops {

/// Of at most 2³¹ numbers.
class MESHOPS_API DisjointSets {
 public:
  explicit DisjointSets(std::size_t size = 0);

  std::size_t size() const { return link_.size(); }
  /// One more number, in a set of its own. Returns: it.
  std::uint32_t add();
  /// The least number of the set.
  std::uint32_t find(std::uint32_t i);
  /// Whether `i` is that itself. Cost: a look.
  bool is_least(std::uint32_t i) const { return link_[i] >> 1U == i; }
  /// Whether `i` is on the other side than the least number of its set.
  /// Requires: find(i) was called after the last unite().
  bool is_odd(std::uint32_t i) const { return (link_[i] & 1U) != 0; }
  /// Makes one set of two, in which `a` and `b` are on different sides when `differ`.
  /// Returns: false when they were in one set already and that says otherwise.
  bool unite(std::uint32_t a, std::uint32_t b, bool differ = false);

 private:
  // Twice the parent, and 1 more when on the other side than that: a step to the parent is one look into memory.
  FreshVector<std::uint32_t> link_;
};

}  // namespace meshops

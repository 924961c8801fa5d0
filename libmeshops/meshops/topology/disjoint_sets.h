// What: union–find over numbers from 0, with the parity of each number to the least of its set.
// Cost: amortised logarithmic, in practice constant.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshops/core/api.h"

namespace meshops {

class MESHOPS_API DisjointSets {
 public:
  explicit DisjointSets(std::size_t size = 0);

  std::size_t size() const { return parent_.size(); }
  /// One more number, in a set of its own. Returns: it.
  std::uint32_t add();
  /// The least number of the set.
  std::uint32_t find(std::uint32_t i);
  /// Whether `i` is on the other side than the least number of its set.
  /// Requires: find(i) was called after the last unite().
  bool is_odd(std::uint32_t i) const { return odd_[i] != 0; }
  /// Makes one set of two, in which `a` and `b` are on different sides when `differ`.
  /// Returns: false when they were in one set already and that says otherwise.
  bool unite(std::uint32_t a, std::uint32_t b, bool differ = false);

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> odd_;  // to the parent
};

}  // namespace meshops

// What:   the sizes of the components of a growing complex, and the sum of the k largest.
// Cost:   add(), remove() and largest() take time logarithmic in the greatest size.
// Source: Fenwick, A new data structure for cumulative frequency tables (1994).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rbpa {

class PartSizes {
 public:
  /// Begins without a component. Requires: sizes from 1 to `greatest`.
  explicit PartSizes(std::uint32_t greatest)
      : count_(greatest + std::size_t{1}), sum_(greatest + std::size_t{1}), top_(std::bit_floor(greatest)) {}

  void add(std::uint32_t size) { change(size, 1); }
  /// Removes a component of this size. Requires: there is one.
  void remove(std::uint32_t size) { change(size, -1); }

  std::size_t count() const { return parts_; }
  std::size_t sum() const { return all_; }

  /// Returns the sum of the `k` largest sizes, or of all sizes if there are fewer than `k`.
  std::size_t largest(std::size_t k) const {
    if (k >= parts_) return all_;
    std::size_t left = parts_ - k, smallest = 0;  // number of smallest sizes that are left out
    std::size_t at = 0;
    for (std::size_t step = top_; step > 0; step /= 2)
      if (at + step < count_.size() && count_[at + step] <= left) {
        at += step;
        left -= count_[at];
        smallest += sum_[at];
      }
    return all_ - smallest - left * (at + 1);
  }

 private:
  void change(std::size_t size, int by) {
    parts_ += static_cast<std::size_t>(by);
    all_ += static_cast<std::size_t>(by) * size;
    for (std::size_t i = size; i < count_.size(); i += i & (~i + 1)) {
      count_[i] += static_cast<std::uint32_t>(by);
      sum_[i] += static_cast<std::size_t>(by) * size;
    }
  }

  // Fenwick trees: entry i sums over the sizes in (j, i], where j is i without its lowest set bit.
  std::vector<std::uint32_t> count_;
  std::vector<std::size_t> sum_;
  std::size_t top_;
  std::size_t parts_ = 0, all_ = 0;
};

}  // namespace rbpa

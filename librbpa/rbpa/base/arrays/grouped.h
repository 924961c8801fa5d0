// What: items in groups, such as triangles by the region that they bound.
// Cost: linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace rbpa::space {

class Grouped {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  /// Groups the items 0 … items − 1: items for which key_of(item) returns one number below `keys` form a group; an item
  /// with the key `none` is in no group. Groups are numbered in the order of their first items.
  template <typename KeyOf>
  Grouped(std::size_t items, std::size_t keys, const KeyOf& key_of) : group_(items, none) {
    std::vector<std::uint32_t> of_key(keys, none);
    for (std::uint32_t i = 0; i < items; ++i) {
      const std::uint32_t key = key_of(i);
      if (key == none) continue;
      if (of_key[key] == none) {
        of_key[key] = static_cast<std::uint32_t>(size());
        begin_.push_back(0);
      }
      group_[i] = of_key[key];
      ++begin_[group_[i] + 1];
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    items_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::uint32_t i = 0; i < items; ++i)
      if (group_[i] != none) items_[next[group_[i]]++] = i;
  }

  std::size_t size() const { return begin_.size() - 1; }
  /// Returns for each item the number of its group, or `none`.
  const std::vector<std::uint32_t>& number() const { return group_; }
  /// Returns the items of a group, ascending.
  std::span<const std::uint32_t> items(std::size_t group) const {
    return std::span(items_).subspan(begin_[group], begin_[group + 1] - begin_[group]);
  }

 private:
  std::vector<std::uint32_t> group_;
  std::vector<std::uint32_t> begin_ = {0}, items_;
};

}  // namespace rbpa::space

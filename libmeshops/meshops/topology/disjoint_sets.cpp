#include "meshops/topology/disjoint_sets.h"

#include <algorithm>

namespace meshops {

DisjointSets::DisjointSets(std::size_t size) : link_(size) {
  for (std::size_t i = 0; i < size; ++i) link_[i] = static_cast<std::uint32_t>(2 * i);
}

std::uint32_t DisjointSets::find(std::uint32_t i) {
  // To the root, with the parity of the whole way; then every element on it becomes a child of the root.
  std::uint32_t root = i, parity = 0;
  for (std::uint32_t link = link_[root]; link >> 1U != root; link = link_[root]) {
    parity ^= link & 1U;
    root = link >> 1U;
  }
  for (std::uint32_t link = link_[i]; link >> 1U != root; link = link_[i]) {
    link_[i] = 2 * root + parity;
    parity ^= link & 1U;
    i = link >> 1U;
  }
  return root;
}

std::uint32_t DisjointSets::add() {
  const auto i = static_cast<std::uint32_t>(link_.size());
  link_.push_back(2 * i);
  return i;
}

bool DisjointSets::unite(std::uint32_t a, std::uint32_t b, bool differ) {
  const std::uint32_t root_a = find(a), root_b = find(b);
  const bool differ_now = is_odd(a) != is_odd(b);
  if (root_a == root_b) return differ_now == differ;
  const std::uint32_t low = std::min(root_a, root_b), high = std::max(root_a, root_b);
  link_[high] = 2 * low + (differ_now != differ ? 1U : 0U);
  return true;
}

}  // namespace meshops

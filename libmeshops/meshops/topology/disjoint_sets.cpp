#include "meshops/topology/disjoint_sets.h"

#include <algorithm>
#include <numeric>

namespace meshops {

DisjointSets::DisjointSets(std::size_t size) : parent_(size), odd_(size, 0) {
  std::iota(parent_.begin(), parent_.end(), 0U);
}

std::uint32_t DisjointSets::find(std::uint32_t i) {
  // To the root, with the parity of the whole way; then every element on it becomes a child of the root.
  std::uint32_t root = i;
  std::uint8_t parity = 0;
  while (parent_[root] != root) {
    parity ^= odd_[root];
    root = parent_[root];
  }
  while (parent_[i] != root && i != root) {
    const std::uint32_t up = parent_[i];
    const std::uint8_t step = odd_[i];
    parent_[i] = root;
    odd_[i] = parity;
    parity ^= step;
    i = up;
  }
  return root;
}

std::uint32_t DisjointSets::add() {
  const auto i = static_cast<std::uint32_t>(parent_.size());
  parent_.push_back(i);
  odd_.push_back(0);
  return i;
}

bool DisjointSets::unite(std::uint32_t a, std::uint32_t b, bool differ) {
  const std::uint32_t root_a = find(a), root_b = find(b);
  const bool differ_now = (odd_[a] ^ odd_[b]) != 0;
  if (root_a == root_b) return differ_now == differ;
  const std::uint32_t low = std::min(root_a, root_b), high = std::max(root_a, root_b);
  parent_[high] = low;
  odd_[high] = differ_now != differ ? 1 : 0;
  return true;
}

}  // namespace meshops

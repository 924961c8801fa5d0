// What: union–find over the numbers from 0, with the parity of each number relative to the least number of its set.
// Cost: amortized logarithmic time for each call, in practice constant; four bytes for each number, and four for rings.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "meshops/core/fresh_vector.h"

namespace meshops {

/// Disjoint sets of at most 2³¹ numbers. Each number of a set is on one of two sides, even or odd; the least number of
/// the set is on the even side. Requires: arguments are below size(); not checked.
class DisjointSets {
 public:
  /// Makes `size` numbers, each in its own set.
  explicit DisjointSets(std::size_t size = 0) : link_(size) {
    for (std::size_t i = 0; i < size; ++i) link_[i] = static_cast<std::uint32_t>(2 * i);
  }

  std::size_t size() const { return link_.size(); }
  /// Adds one number, in its own set. Returns: the number.
  std::uint32_t add() {
    const auto i = static_cast<std::uint32_t>(link_.size());
    link_.push_back(2 * i);
    return i;
  }
  /// Returns the least number of the set of `i`.
  std::uint32_t find(std::uint32_t i) {
    const std::uint32_t parent = link_[i] >> 1U;
    return is_least(parent) ? parent : compress(i);  // the parent is nearly always the least number
  }
  /// Returns whether `i` is the least number of its set. Cost: constant.
  bool is_least(std::uint32_t i) const { return link_[i] >> 1U == i; }
  /// Returns whether `i` and the least number of its set are on different sides.
  /// Requires: find(i) was called after the last change of the sets; not checked.
  bool is_odd(std::uint32_t i) const { return (link_[i] & 1U) != 0; }

  /// Merges the sets whose least numbers are `a` and `b`, on the same side. Returns: the lesser.
  /// Requires: `a` and `b` are the least numbers of their sets; not checked.
  std::uint32_t link(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    link_[high] = 2 * low;
    return low;
  }
  /// Merges the sets of `a` and `b`, so that the least numbers of the two sets are on the same side. Returns: whether
  /// the sets were different before.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    link(a, b);
    return true;
  }
  /// Merges the sets of `a` and `b` as join() does. Several threads may call this function at once, but no other one.
  /// Requires: all numbers are on the even side; not checked.
  void join_among_threads(std::uint32_t a, std::uint32_t b) {
    constexpr auto relaxed = std::memory_order_relaxed;  // a link announces no other data
    const auto parent_of = [&](std::uint32_t i) { return std::atomic_ref(link_[i]).load(relaxed) >> 1U; };
    const auto least_of = [&](std::uint32_t i) {
      for (std::uint32_t parent = parent_of(i), next; parent != i; i = parent, parent = next)
        if ((next = parent_of(parent)) != parent) std::atomic_ref(link_[i]).store(2 * next, relaxed);
      return i;
    };
    for (std::uint32_t own = 0; (a = least_of(a)) != (b = least_of(b));) {
      if (a > b) std::swap(a, b);
      own = 2 * b;  // another link if another thread has merged b meanwhile
      if (std::atomic_ref(link_[b]).compare_exchange_strong(own, 2 * a, relaxed)) return;
    }
  }
  /// Merges the sets of `a` and `b`, so that `a` and `b` are on different sides exactly if `differ` is true. Returns:
  /// false if `a` and `b` were in one set already and their sides contradict `differ`; otherwise true.
  bool unite(std::uint32_t a, std::uint32_t b, bool differ = false) {
    const std::uint32_t root_a = find(a), root_b = find(b);
    const bool differ_now = is_odd(a) != is_odd(b);
    if (root_a == root_b) return differ_now == differ;
    const auto [low, high] = std::minmax(root_a, root_b);
    link_[high] = 2 * low + (differ_now != differ ? 1U : 0U);
    return true;
  }

 private:
  /// Follows the links from `i` to the least number of its set and adds up the parities. Then links every number on the
  /// way directly to the least number. Returns: the least number.
  [[gnu::noinline]] std::uint32_t compress(std::uint32_t i) {
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

  // link_[i] is twice the parent of i, plus 1 if i and its parent are on different sides, so that one read gives both.
  FreshVector<std::uint32_t> link_;
};

/// The members of disjoint sets, each set as a ring; at first each number is in its own ring.
class MemberRings {
 public:
  explicit MemberRings(std::size_t size) : next_(size) { std::iota(next_.begin(), next_.end(), 0U); }

  /// Merges the rings of `a` and `b`. Requires: the rings differ; not checked.
  void join(std::uint32_t a, std::uint32_t b) { std::swap(next_[a], next_[b]); }
  /// Calls visit(member) for each member of the ring of `i`. The last call has `i`.
  template <typename Visit>
  void for_each(std::uint32_t i, const Visit& visit) const {
    std::uint32_t member = i;
    do visit(member = next_[member]);
    while (member != i);
  }

 private:
  FreshVector<std::uint32_t> next_;
};

}  // namespace meshops

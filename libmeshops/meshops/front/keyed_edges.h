// What: priority queues of halfedges by key: the least key comes first, and among equal keys the oldest halfedge.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "meshops/core/connectivity.h"

namespace meshops::detail {

/// Halfedge with its age.
struct Aged {
  std::size_t age = 0;
  Halfedge halfedge;
};

template <typename Key>
struct KeyedEdge {
  Key key;
  std::size_t age;
  Halfedge halfedge;
  friend bool operator<(const KeyedEdge& a, const KeyedEdge& b) {
    return a.key < b.key || (!(b.key < a.key) && a.age < b.age);
  }
  friend bool operator>(const KeyedEdge& a, const KeyedEdge& b) { return b < a; }
};

/// Queue for keys that do not change: a heap. A halfedge that is pushed twice is in the queue twice.
template <typename Key>
class KeyedEdges {
 public:
  using Entry = KeyedEdge<Key>;
  bool empty() const { return heap_.empty(); }
  void push(Entry entry) {
    heap_.push_back(std::move(entry));
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
  }
  const Entry& least() const { return heap_.front(); }
  void pop() {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    heap_.pop_back();
  }
  /// Returns the entry that the next pop() holds outside the heap while it compares and moves keys, which may throw.
  Aged moved_by_pop() const { return {heap_.back().age, heap_.back().halfedge}; }
  /// Returns all entries, in any order.
  std::vector<Aged> aged() const {
    std::vector<Aged> all;
    all.reserve(heap_.size() + 1);
    for (const Entry& entry : heap_) all.push_back({entry.age, entry.halfedge});
    return all;
  }

 private:
  std::vector<Entry> heap_;
};

/// Queue for keys that change: a search tree, in which a halfedge is found by its handle. A halfedge that is pushed
/// twice is in the queue once, with its last key and age.
template <typename Key>
class RekeyedEdges {
 public:
  using Entry = KeyedEdge<Key>;
  bool empty() const { return tree_.empty(); }
  bool contains(Halfedge h) const { return index(h) < place_.size() && place_[index(h)] != tree_.end(); }
  /// Returns the age of `h`. age() and rekey() require contains(h); not checked.
  std::size_t age(Halfedge h) const { return place_[index(h)]->age; }
  void rekey(Halfedge h, Key key) {
    auto entry = tree_.extract(std::exchange(place_[index(h)], tree_.end()));
    entry.value().key = std::move(key);
    place_[index(h)] = tree_.insert(std::move(entry)).position;
  }
  void push(Entry entry) {
    const Halfedge h = entry.halfedge;
    if (contains(h)) tree_.erase(std::exchange(place_[index(h)], tree_.end()));
    if (index(h) >= place_.size()) place_.resize(index(h) + 1, tree_.end());
    place_[index(h)] = tree_.insert(std::move(entry)).first;
  }
  const Entry& least() const { return *tree_.begin(); }
  void pop() {
    place_[index(least().halfedge)] = tree_.end();
    tree_.erase(tree_.begin());
  }
  /// Returns an empty entry, because pop() neither compares nor moves keys.
  Aged moved_by_pop() const { return Aged(); }
  std::vector<Aged> aged() const {
    std::vector<Aged> all;
    all.reserve(tree_.size() + 1);
    for (const Entry& entry : tree_) all.push_back({entry.age, entry.halfedge});
    return all;
  }

 private:
  using Tree = std::set<Entry>;
  static std::size_t index(Halfedge h) { return static_cast<std::size_t>(h.idx()); }
  Tree tree_;
  std::vector<typename Tree::iterator> place_;  // for each halfedge: its entry, or the end of the tree
};

}  // namespace meshops::detail

// What: the order in which an advancing front processes its active halfedges.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/core/connectivity.h"
#include "meshops/front/engine_side.h"
#include "meshops/front/policy.h"

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

/// Order first in, first out: the queue of the front itself.
template <typename Policy>
class FirstInFirstOut {
 public:
  FirstInFirstOut(Front& front, Policy&) : front_(front) {}
  /// Removes and returns the next active halfedge, which then is inactive; an invalid handle if there is none.
  Halfedge next() {
    const Halfedge h = EngineSide(front_).next_queued();
    if (h.is_valid()) EngineSide(front_).take(h);
    return h;
  }
  /// After an exception, puts `in_hand`, the halfedge that next() returned last, first in the queue
  /// (EngineSide::requeue()).
  void give_back(Halfedge in_hand) { EngineSide(front_).requeue(in_hand, {}); }

 private:
  Front& front_;
};

/// Order by keys: the least key comes first, and among equal keys the oldest halfedge. The queue of the front has only
/// halfedges that became active after the last next(). A halfedge that is inactive when its turn comes is skipped.
template <typename Policy>
class LeastKeyFirst {
 public:
  LeastKeyFirst(Front& front, Policy& policy) : front_(front), policy_(policy) {}

  Halfedge next() {
    const EngineSide engine(front_);
    if constexpr (rekeys)
      for (; !changed_.empty(); changed_.pop_back())
        if (const Halfedge h = changed_.back(); front_.is_active(h) && keyed_.contains(h)) {
          moving_ = {keyed_.age(h), h};
          keyed_.rekey(h, key(h));
          moving_ = Aged();
        }
    for (Halfedge h = engine.next_queued(); h.is_valid(); h = engine.next_queued()) {
      moving_ = {age_++, h};
      keyed_.push({key(h), moving_.age, h});
      moving_ = Aged();
    }
    while (!keyed_.empty()) {
      const Halfedge h = keyed_.least().halfedge;
      moving_ = keyed_.moved_by_pop();
      keyed_.pop();
      moving_ = Aged();
      if (engine.take(h)) return h;
    }
    return Halfedge();
  }

  /// Notes that a triangle at the vertex was inserted or detached.
  void neighbors_changed(Vertex v) {
    const Connectivity& mesh = front_.mesh();
    const Halfedge out = mesh.halfedge_handle(v);
    if (!out.is_valid() || !mesh.is_boundary(out)) return;
    changed_.push_back(out);
    changed_.push_back(mesh.prev_halfedge_handle(out));
  }

  /// After an exception, returns the halfedges that are still active to the queue of the front, the oldest first. Reads
  /// no keys, because comparing or moving keys may have thrown the exception.
  void give_back(Halfedge in_hand) {
    std::vector<Aged> waiting = keyed_.aged();
    waiting.push_back(moving_);
    std::sort(waiting.begin(), waiting.end(), [](const Aged& a, const Aged& b) { return a.age < b.age; });
    std::vector<Halfedge> oldest_first;
    oldest_first.reserve(waiting.size());
    for (const Aged& one : waiting) oldest_first.push_back(one.halfedge);
    EngineSide(front_).requeue(in_hand, oldest_first);
  }

 private:
  static constexpr bool rekeys = RekeyingFrontPolicy<Policy>;
  using Key = std::remove_cvref_t<decltype(std::declval<Policy&>().key(std::declval<const Front&>(), Halfedge()))>;
  Key key(Halfedge h) {
    return EngineSide(front_).ask([&] { return policy_.key(std::as_const(front_), h); });
  }

  Front& front_;
  Policy& policy_;
  std::conditional_t<rekeys, RekeyedEdges<Key>, KeyedEdges<Key>> keyed_;
  std::vector<Halfedge> changed_;  // halfedges whose neighbors on the curve may have changed
  Aged moving_;                    // the entry that is being moved into keyed_ or within it
  std::size_t age_ = 0;
};

template <typename Policy>
struct OrderOf {
  using type = FirstInFirstOut<Policy>;
};
template <OrderedFrontPolicy Policy>
struct OrderOf<Policy> {
  using type = LeastKeyFirst<Policy>;
};

}  // namespace meshops::detail

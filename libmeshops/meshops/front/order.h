// What: in which order an advancing front takes its active halfedges.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/front/engine_side.h"
#include "meshops/front/policy.h"

namespace meshops::detail {

/// First in, first out: the front's own queue.
template <typename Policy>
class FirstInFirstOut {
 public:
  FirstInFirstOut(Front& front, Policy&) : front_(front) {}
  Halfedge next() { return front_.pop(); }
  void give_back(Halfedge in_hand) { EngineSide(front_).requeue(in_hand, {}); }

 private:
  Front& front_;
};

/// The least key first, of equal ones the oldest. The front's queue only has what is new; whether a halfedge is still
/// active when its turn comes, the front knows.
template <typename Policy>
class LeastKeyFirst {
 public:
  LeastKeyFirst(Front& front, Policy& policy) : front_(front), policy_(policy) {}

  Halfedge next() {
    const EngineSide engine(front_);
    for (Halfedge h = engine.next_queued(); h.is_valid(); h = engine.next_queued()) {
      moving_ = {age_++, h};
      queue_.push_back({engine.ask([&] { return policy_.key(std::as_const(front_), h); }), moving_.age, h});
      std::push_heap(queue_.begin(), queue_.end());
      moving_ = Waiting();
    }
    while (!queue_.empty()) {
      const Halfedge h = queue_.front().halfedge;
      moving_ = {queue_.back().age, queue_.back().halfedge};
      std::pop_heap(queue_.begin(), queue_.end());
      queue_.pop_back();
      moving_ = Waiting();
      if (engine.take(h)) return h;
    }
    return Halfedge();
  }

  /// After a throw: what is still active goes back to the front's queue, the oldest first. Keys, their order and their moves
  /// may have thrown: nothing is read of the heap but which halfedges are in it.
  void give_back(Halfedge in_hand) {
    std::vector<Waiting> waiting;
    waiting.reserve(queue_.size() + 1);
    for (const Entry& entry : queue_) waiting.push_back({entry.age, entry.halfedge});
    waiting.push_back(moving_);
    std::sort(waiting.begin(), waiting.end(), [](const Waiting& a, const Waiting& b) { return a.age < b.age; });
    std::vector<Halfedge> oldest_first;
    oldest_first.reserve(waiting.size());
    for (const Waiting& one : waiting) oldest_first.push_back(one.halfedge);
    EngineSide(front_).requeue(in_hand, oldest_first);
    queue_.clear();
  }

 private:
  using Key = std::remove_cvref_t<decltype(std::declval<Policy&>().key(std::declval<const Front&>(), Halfedge()))>;
  struct Entry {
    Key key;
    std::size_t age;
    Halfedge halfedge;
    /// A heap has the greatest on top.
    friend bool operator<(const Entry& a, const Entry& b) {
      return b.key < a.key || (!(a.key < b.key) && b.age < a.age);
    }
  };
  struct Waiting {
    std::size_t age = 0;
    Halfedge halfedge;
  };
  Front& front_;
  Policy& policy_;
  std::vector<Entry> queue_;  // a heap
  Waiting moving_;            // on its way into the heap, or within it
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

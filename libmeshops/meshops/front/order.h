// What: in which order an advancing front takes its active halfedges.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/front/policy.h"

namespace meshops::detail {

/// First in, first out: the front's own queue.
template <typename Policy>
class FirstInFirstOut {
 public:
  FirstInFirstOut(Front& front, Policy&) : front_(front) {}
  Halfedge next() { return front_.pop(); }
  void give_back() {}

 private:
  Front& front_;
};

/// The least key first, of equal ones the oldest. The front's queue only tells what is new; whether a halfedge is still
/// active when its turn comes, the front knows.
template <typename Policy>
class LeastKeyFirst {
 public:
  LeastKeyFirst(Front& front, Policy& policy) : front_(front), policy_(policy) {}

  Halfedge next() {
    for (Halfedge h = front_.next_queued(); h.is_valid(); h = front_.next_queued()) {
      queue_.push_back({policy_.key(std::as_const(front_), h), age_++, h});
      std::push_heap(queue_.begin(), queue_.end());
    }
    while (!queue_.empty()) {
      std::pop_heap(queue_.begin(), queue_.end());
      const Halfedge h = queue_.back().halfedge;
      queue_.pop_back();
      if (front_.take(h)) return h;
    }
    return Halfedge();
  }

  /// What is still active goes back to the front's queue, the oldest first.
  void give_back() {
    std::sort(queue_.begin(), queue_.end(), [](const Entry& a, const Entry& b) { return a.age < b.age; });
    for (const Entry& entry : queue_)
      if (front_.take(entry.halfedge)) front_.activate(entry.halfedge);
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
  Front& front_;
  Policy& policy_;
  std::vector<Entry> queue_;  // a heap
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

// What: the order in which an advancing front processes its active halfedges.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/front/engine_side.h"
#include "meshops/front/keyed_edges.h"
#include "meshops/front/policy.h"

namespace meshops::detail {

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

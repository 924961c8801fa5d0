// What: the boundary halfedges of a front that wait for a triangle: active ones for their turn, deferred ones for a change,
//       frozen ones for the next level.
// Law:  a boundary halfedge waits in one way at most, however often it was queued; what is on the boundary no longer does
//       not wait.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/api.h"
#include "meshops/core/connectivity.h"
#include "meshops/core/live.h"

namespace meshops::detail {

class MESHOPS_API WaitingEdges {
 public:
  explicit WaitingEdges(const Connectivity& mesh) : mesh_(mesh) {}

  /// Deferred halfedges are active as well.
  bool is_active(Halfedge h) const { return state(h) >= State::active; }
  bool is_deferred(Halfedge h) const { return state(h) == State::deferred; }
  bool is_frozen(Halfedge h) const { return state(h) == State::frozen; }
  bool is_waiting(Halfedge h) const { return state(h) != State::neither; }

  /// Makes a boundary halfedge active, last in the queue, whatever it was.
  void queue(Halfedge h);
  void freeze(Halfedge h) {
    frozen_.push_back(h);
    set_state(h, State::frozen);
  }
  /// Active halfedges, in the order of the queue; for a front that has none yet.
  void queue_all(std::vector<Halfedge>&& active);
  /// The halfedge waits no longer: it was popped, or its edge was deleted.
  void release(Halfedge h) { set_state(h, State::neither); }
  /// The same of an active one that is not deferred. Returns: whether it was one.
  bool release_queued(Halfedge h) {
    const bool was_queued = state(h) == State::active;
    if (was_queued) release(h);
    return was_queued;
  }

  /// Removes from the queue the next that is active, not deferred, and stays so; an invalid handle when there is none.
  /// Throws: ContractViolation when others have deleted it.
  Halfedge next();
  /// Queues every active halfedge once that is not deferred: those of `first`, then what was queued, then all others.
  void requeue(std::span<const Halfedge> first);

  /// Puts off a boundary halfedge until the revision of the front, which only grows, is no longer this one.
  void defer(Halfedge h, std::size_t revision);
  /// Queues those that were deferred at other revisions than this one, in that order. Returns: whether there were any.
  bool wake_deferred(std::size_t revision);
  /// Removes the one that was deferred first, which stays active; an invalid handle when there is none.
  Halfedge next_deferred();

  /// What was frozen at this level, in that order; some of it may have been woken or attached to since.
  const std::vector<Halfedge>& frozen() const { return frozen_; }
  /// Visits those that are frozen, queued and deferred, some of them several times.
  /// Throws: ContractViolation when others have deleted one.
  template <typename Visit>
  void for_each(Visit visit) const {
    for (const Halfedge h : frozen_)
      if (is_frozen(h)) visit(checked(h));
    for (std::size_t i = head_; i < active_.size(); ++i)
      if (is_active(active_[i])) visit(checked(active_[i]));
    for (const Halfedge h : deferred_)
      if (is_deferred(h)) visit(checked(h));
  }
  /// Queues what is frozen, in that order. Returns: how many those are.
  std::size_t wake_all();

  /// Frees the memory.
  void clear();

 private:
  enum class State : std::uint8_t { neither, frozen, active, deferred };

  State state(Halfedge h) const {
    const auto edge = static_cast<std::size_t>(h.idx()) / 2;
    return h.idx() >= 0 && edge < state_.size() && mesh_.is_boundary(h) ? state_[edge] : State::neither;
  }
  void set_state(Halfedge h, State state);
  /// An edge leaves the boundary by the front only.
  Halfedge checked(Halfedge h) const {
    if (!is_live(mesh_, h)) [[unlikely]]
      deleted_by_others();
    return h;
  }
  [[noreturn, gnu::cold, gnu::noinline]] static void deleted_by_others();

  const Connectivity& mesh_;
  std::vector<State> state_;      // of each edge's boundary halfedge, if it has one; behind the end: neither
  std::vector<Halfedge> active_;  // a queue from head_ on; what is no longer active is passed over
  std::size_t head_ = 0;
  std::vector<Halfedge> frozen_;
  std::vector<Halfedge> deferred_;  // a queue from deferred_head_ on, in the order of revisions
  std::size_t deferred_head_ = 0;
  std::size_t deferred_now_ = 0;       // where those of the last revision begin
  std::size_t deferred_revision_ = 0;  // the last
};

}  // namespace meshops::detail

// What: the boundary halfedges of a front that wait for a triangle: active ones for their turn, deferred ones for a
//       change, frozen ones for the next level.
// Law:  a boundary halfedge waits in at most one way, however often it was queued; a halfedge that left the boundary
//       does not wait.
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

  /// Makes a boundary halfedge active and puts it at the end of the queue, whatever its state was.
  void queue(Halfedge h);
  void freeze(Halfedge h) {
    frozen_.push_back(h);
    set_state(h, State::frozen);
  }
  /// Makes these halfedges active and queues them in this order. Requires: no halfedge waits yet; not checked.
  void queue_all(std::vector<Halfedge>&& active);
  /// Ends the waiting of a halfedge that was popped, or whose edge was deleted.
  void release(Halfedge h) { set_state(h, State::neither); }
  /// Ends the waiting of an active halfedge that is not deferred. Returns: whether it was one.
  bool release_queued(Halfedge h) {
    const bool was_queued = state(h) == State::active;
    if (was_queued) release(h);
    return was_queued;
  }

  /// Removes from the queue and returns its next halfedge that is active and not deferred, and that stays active; an
  /// invalid handle when there is none.
  /// Throws: ContractViolation when other code has deleted it.
  Halfedge next();
  /// Queues every active halfedge that is not deferred, once: first the halfedges of `first`, then the queue as it was,
  /// then all others.
  void requeue(std::span<const Halfedge> first);

  /// Defers a boundary halfedge until the revision of the front, which only grows, has changed.
  void defer(Halfedge h, std::size_t revision);
  /// Queues the halfedges that were deferred at other revisions, in order of deferral. Returns: whether there were any.
  bool wake_deferred(std::size_t revision);
  /// Removes and returns the halfedge deferred first, which stays active; an invalid handle when there is none.
  Halfedge next_deferred();

  /// Returns the halfedges that were frozen at this level, in the order in which they were frozen. Some may have been
  /// activated or glued since.
  const std::vector<Halfedge>& frozen() const { return frozen_; }
  /// Visits the frozen, queued and deferred halfedges, some of them several times.
  /// Throws: ContractViolation when other code has deleted one.
  template <typename Visit>
  void for_each(Visit visit) const {
    for (const Halfedge h : frozen_)
      if (is_frozen(h)) visit(checked(h));
    for (std::size_t i = head_; i < active_.size(); ++i)
      if (is_active(active_[i])) visit(checked(active_[i]));
    for (const Halfedge h : deferred_)
      if (is_deferred(h)) visit(checked(h));
  }
  /// Queues the frozen halfedges, in the order in which they were frozen. Returns: their number.
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
  /// Returns `h`. Throws ContractViolation if other code has deleted its edge: only the front may remove edges.
  Halfedge checked(Halfedge h) const {
    if (!is_live(mesh_, h)) [[unlikely]]
      deleted_by_others();
    return h;
  }
  [[noreturn, gnu::cold, gnu::noinline]] static void deleted_by_others();

  const Connectivity& mesh_;
  std::vector<State> state_;      // for each edge, the state of its boundary halfedge; past the end: neither
  std::vector<Halfedge> active_;  // a queue from head_ on; halfedges that are no longer active are skipped
  std::size_t head_ = 0;
  std::vector<Halfedge> frozen_;
  std::vector<Halfedge> deferred_;  // a queue from deferred_head_ on, in the order of revisions
  std::size_t deferred_head_ = 0;
  std::size_t deferred_now_ = 0;       // start of the halfedges deferred at deferred_revision_
  std::size_t deferred_revision_ = 0;  // the revision of the last defer()
};

}  // namespace meshops::detail

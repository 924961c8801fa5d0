// What: the boundary halfedges of a front that wait: active ones for their turn, deferred ones for a change of the
//       front, frozen ones for the next level.
// Law:  a boundary halfedge waits in at most one way, however often it was queued. A halfedge that left the boundary
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

/// Waiting boundary halfedges of a front, with their queue. Keeps a reference to the mesh. The is_…() functions return
/// false for any handle that is not a boundary halfedge.
/// Requires: halfedges that are queued, frozen or deferred are on the boundary. Not checked.
/// Cost:     amortized constant for each entry that a function adds, visits or skips, unless stated otherwise.
class MESHOPS_API WaitingEdges {
 public:
  explicit WaitingEdges(const Connectivity& mesh) : mesh_(mesh) {}

  /// Returns whether `h` is active; a deferred halfedge is also active.
  bool is_active(Halfedge h) const { return state(h) >= State::active; }
  bool is_deferred(Halfedge h) const { return state(h) == State::deferred; }
  bool is_frozen(Halfedge h) const { return state(h) == State::frozen; }
  bool is_waiting(Halfedge h) const { return state(h) != State::neither; }

  /// Makes a boundary halfedge active, whatever its state was, and puts the halfedge at the end of the queue. An entry
  /// that the queue has already stays, too.
  void queue(Halfedge h);
  /// Makes a boundary halfedge frozen, whatever its state was, and lists the halfedge in frozen().
  void freeze(Halfedge h) {
    frozen_.push_back(h);
    set_state(h, State::frozen);
  }
  /// Makes the given halfedges active, and queues them in their order. Requires: nothing was queued yet; not checked.
  /// Cost: linear in the edges of the mesh.
  void queue_all(std::vector<Halfedge>&& active);
  /// Ends the waiting of a halfedge that was popped or whose edge was deleted.
  void release(Halfedge h) { set_state(h, State::neither); }
  /// Ends the waiting of `h` if `h` is active and not deferred. Returns: whether `h` was active and not deferred.
  bool release_queued(Halfedge h) {
    const bool was_queued = state(h) == State::active;
    if (was_queued) release(h);
    return was_queued;
  }

  /// Removes from the queue and returns the next halfedge that is active and not deferred; an invalid handle if there
  /// is none. The halfedge stays active; if it was queued twice, next() returns it again, unless release() is called.
  /// Throws: ContractViolation if other code has deleted the halfedge; so do wake_deferred() and next_deferred().
  Halfedge next();
  /// Queues every active halfedge that is not deferred, once: first those of `first`, then the present queue, then all
  /// others. Cost: linear in the edges of the mesh.
  void requeue(std::span<const Halfedge> first);

  /// Defers a boundary halfedge until the revision of the front has changed. Requires: `revision` never decreases.
  void defer(Halfedge h, std::size_t revision);
  /// Queues the halfedges deferred at other revisions, in the order of deferral. Returns: whether there were any.
  bool wake_deferred(std::size_t revision);
  /// Removes and returns the halfedge deferred first; an invalid handle if there is none. The halfedge stays active.
  Halfedge next_deferred();

  /// Returns the halfedges that were frozen at this level, in the order in which they were frozen. Some may have been
  /// activated or glued later.
  const std::vector<Halfedge>& frozen() const { return frozen_; }
  /// Visits the frozen, queued and deferred halfedges; some may be visited several times.
  /// Throws: ContractViolation if other code has deleted one.
  template <typename Visit>
  void for_each(Visit visit) const {
    for (const Halfedge h : frozen_)
      if (is_frozen(h)) visit(checked(h));
    for (std::size_t i = head_; i < active_.size(); ++i)
      if (is_active(active_[i])) visit(checked(active_[i]));
    for (const Deferred& entry : deferred_)
      if (is_current(entry)) visit(checked(entry.h));
  }
  /// Queues the frozen halfedges, in the order in which they were frozen. Returns: their number.
  std::size_t wake_all();

  /// Ends the waiting of all halfedges, and frees the memory.
  void clear();

 private:
  enum class State : std::uint8_t { neither, frozen, active, deferred };

  State state(Halfedge h) const {
    const auto edge = static_cast<std::size_t>(h.idx()) / 2;
    return h.idx() >= 0 && edge < state_.size() && mesh_.is_boundary(h) ? state_[edge] : State::neither;
  }
  void set_state(Halfedge h, State state);
  struct Deferred {
    Halfedge h;
    std::size_t number;  // of all deferrals
  };
  /// Returns whether the halfedge is deferred, and was not deferred again later.
  bool is_current(const Deferred& entry) const {
    return is_deferred(entry.h) && last_deferral_[static_cast<std::size_t>(entry.h.idx()) / 2] == entry.number;
  }
  /// Returns `h`. Throws ContractViolation if other code has deleted the edge of `h`: only the front may delete edges.
  Halfedge checked(Halfedge h) const {
    if (!is_live(mesh_, h)) [[unlikely]]
      deleted_by_others();
    return h;
  }
  [[noreturn, gnu::cold, gnu::noinline]] static void deleted_by_others();

  const Connectivity& mesh_;
  std::vector<State> state_;      // for each edge, the state of its boundary halfedge; `neither` past the end
  std::vector<Halfedge> active_;  // a queue from head_ on; halfedges that are no longer active are skipped
  std::size_t head_ = 0;
  std::vector<Halfedge> frozen_;
  std::vector<Deferred> deferred_;          // a queue from deferred_head_ on; the revisions of the deferrals ascend
  std::vector<std::size_t> last_deferral_;  // for each edge that was deferred, the number of its last deferral
  std::size_t deferrals_ = 0;
  std::size_t deferred_head_ = 0;
  std::size_t deferred_now_ = 0;       // index in deferred_ of the first halfedge deferred at deferred_revision_
  std::size_t deferred_revision_ = 0;  // the revision of the last defer()
};

}  // namespace meshops::detail

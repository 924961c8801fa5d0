// What: operations on a front for advance() alone: calls of a policy or a visitor during which the front refuses
//       changes, and the order in which its active halfedges wait.
#pragma once

#include <exception>
#include <span>

#include "meshops/front/front.h"

namespace meshops::detail {

class EngineSide {
 public:
  explicit EngineSide(Front& front) : front_(front) {}

  /// Calls the policy. During the call, changes of the front are refused. Returns: the answer of the policy.
  /// Throws:  what the policy throws; ContractViolation when it changed the mesh.
  template <typename Ask>
  auto ask(Ask question) const {
    const Guard::Call call(front_.guard_, Guard::Caller::policy);
    auto answer = question();
    front_.guard_.require_intact();
    return answer;
  }

  /// Calls the visitor, which may activate and freeze edges.
  /// Throws: what the visitor throws; ContractViolation when it changed the mesh.
  template <typename Event>
  void notify(Event event) const {
    const Guard::Call call(front_.guard_, Guard::Caller::visitor);
    event();
    front_.guard_.require_intact();
  }

  /// Returns whether no other code has changed the mesh.
  bool is_intact() const { return front_.guard_.is_intact(); }

  /// Removes and returns the next active halfedge of the queue. It stays active.
  Halfedge next_queued() const {
    front_.guard_.require_intact();
    return front_.waiting_.next();
  }
  /// Makes `h` inactive if it is active and not deferred. Returns: whether it was.
  bool take(Halfedge h) const {
    front_.guard_.require_intact();
    return front_.waiting_.release_queued(h);
  }
  /// Makes `h`, the halfedge being processed, active again, to wait until a triangle is inserted or detached.
  void defer(Halfedge h) const { front_.waiting_.defer(h, front_.revision()); }
  /// Queues the halfedges since whose deferral a triangle was inserted or detached. Returns: whether there were any.
  bool wake_deferred() const { return front_.waiting_.wake_deferred(front_.revision()); }
  /// Removes and returns the first deferred halfedge. It stays active.
  Halfedge next_deferred() const { return front_.waiting_.next_deferred(); }
  /// After a throw, queues every active halfedge that is not deferred, once: first `in_hand`, which was being
  /// processed, if it is still a boundary halfedge, then `next`, then those that were queued, then all others. Does
  /// nothing when the front is not intact.
  void requeue(Halfedge in_hand, std::span<const Halfedge> next) const { front_.requeue(in_hand, next); }

 private:
  Front& front_;
};

/// Runs the steps of one change one by one, also those after a step that throws, so that no event is lost. After a
/// throw, steps are skipped when other code has changed the mesh. Call end() last.
class AllSteps {
 public:
  explicit AllSteps(const EngineSide& engine) : engine_(engine) {}

  template <typename Step>
  void operator()(Step step) {
    if (first_ && !engine_.is_intact()) return;
    try {
      step();
    } catch (...) {
      if (!first_) first_ = std::current_exception();
    }
  }
  /// Throws the first exception, if there was one.
  void end() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  const EngineSide& engine_;
  std::exception_ptr first_;
};

}  // namespace meshops::detail

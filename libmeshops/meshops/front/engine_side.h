// What: operations on a front for the engine alone: calling a policy or a visitor while the front refuses changes, and
//       ordering its queue.
#pragma once

#include <exception>
#include <span>

#include "meshops/front/front.h"

namespace meshops::detail {

class EngineSide {
 public:
  explicit EngineSide(Front& front) : front_(front) {}

  /// Returns: what the policy returns. During the call, changes of the front are refused.
  /// Throws:  what the policy throws; ContractViolation when it changed the mesh.
  template <typename Ask>
  auto ask(Ask question) const {
    const Guard::Call call(front_.guard_, Guard::Caller::policy);
    auto answer = question();
    front_.guard_.require_intact();
    return answer;
  }

  /// Calls the visitor, which may activate and freeze edges.
  template <typename Event>
  void notify(Event event) const {
    const Guard::Call call(front_.guard_, Guard::Caller::visitor);
    event();
    front_.guard_.require_intact();
  }

  /// Returns whether no other code has changed the mesh.
  bool is_intact() const { return front_.guard_.is_intact(); }

  /// The next in the queue that is active, and stays so; it is in no queue any more.
  Halfedge next_queued() const {
    front_.guard_.require_intact();
    return front_.waiting_.next();
  }
  /// An active halfedge that is not deferred is active no longer. Returns: whether it was one.
  bool take(Halfedge h) const {
    front_.guard_.require_intact();
    return front_.waiting_.release_queued(h);
  }
  /// A boundary halfedge in hand is active again, and waits for a triangle that is inserted or detached.
  void defer(Halfedge h) const { front_.waiting_.defer(h, front_.revision()); }
  /// Queues those that have waited for it. Returns: whether there were any.
  bool wake_deferred() const { return front_.waiting_.wake_deferred(front_.revision()); }
  /// The first that waits for it, which is active, and in no queue any more.
  Halfedge next_deferred() const { return front_.waiting_.next_deferred(); }
  /// After a throw: queues every active halfedge once that is not deferred. First the one in hand, if it is still to be
  /// processed, then `next`, then what was queued, then all others. Nothing when the front is not intact.
  void requeue(Halfedge in_hand, std::span<const Halfedge> next) const { front_.requeue(in_hand, next); }

 private:
  Front& front_;
};

/// Takes all steps of one change, also those behind one that throws, so that none of it is lost; but none on a mesh
/// that somebody else has changed.
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
  /// Throws what came first.
  void end() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  const EngineSide& engine_;
  std::exception_ptr first_;
};

}  // namespace meshops::detail

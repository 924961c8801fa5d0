// What: operations on a front for advance() alone: calls of a policy or a visitor, during which the front refuses
//       changes, and access to the queue of active halfedges.
#pragma once

#include <exception>
#include <span>

#include "meshops/front/front.h"

namespace meshops::detail {

class EngineSide {
 public:
  explicit EngineSide(Front& front) : front_(front) {}

  /// Calls the policy; during the call, the front refuses changes. Returns: the answer of the policy.
  /// Throws:  whatever the policy throws; ContractViolation if the policy changed the mesh.
  template <typename Ask>
  auto ask(Ask question) const {
    const Guard::Call call(front_.guard_, Guard::Caller::policy);
    auto answer = question();
    front_.guard_.require_intact();
    return answer;
  }

  /// Calls the visitor; during the call, the front refuses changes except activate() and freeze().
  /// Throws: whatever the visitor throws; ContractViolation if the visitor changed the mesh.
  template <typename Event>
  void notify(Event event) const {
    const Guard::Call call(front_.guard_, Guard::Caller::visitor);
    event();
    front_.guard_.require_intact();
  }

  /// Returns whether the front is not finished and no other code has changed the numbers of elements of the mesh.
  bool is_intact() const { return front_.guard_.is_intact(); }

  /// Removes and returns the next active halfedge of the queue; an invalid handle if there is none. It stays active.
  Halfedge next_queued() const {
    front_.guard_.require_intact();
    return front_.waiting_.next();
  }
  /// Makes `h` inactive if it is active and not deferred. Returns: whether `h` was active and not deferred.
  bool take(Halfedge h) const {
    front_.guard_.require_intact();
    return front_.waiting_.release_queued(h);
  }
  /// Makes `h`, the halfedge in processing, active again, but deferred until a triangle is inserted or detached.
  void defer(Halfedge h) const { front_.waiting_.defer(h, front_.revision()); }
  /// Queues the halfedges that were deferred before the last insertion or detachment. Returns: whether there were any.
  bool wake_deferred() const { return front_.waiting_.wake_deferred(front_.revision()); }
  /// Removes and returns the first deferred halfedge; an invalid handle if there is none. It stays active.
  Halfedge next_deferred() const { return front_.waiting_.next_deferred(); }
  /// After an exception, queues every active halfedge that is not deferred, once: first `in_hand`, the halfedge in
  /// processing, if it is still a boundary halfedge; then the halfedges of `next`; then the queue; then all others.
  /// Does nothing if the front is not intact.
  void requeue(Halfedge in_hand, std::span<const Halfedge> next) const { front_.requeue(in_hand, next); }

 private:
  Front& front_;
};

/// Runner of the steps of one change. A step also runs after an earlier step threw, so that no event is lost, unless
/// other code has changed the mesh. Call end() last.
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
  /// Throws the first exception of a step, if any step threw.
  void end() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  const EngineSide& engine_;
  std::exception_ptr first_;
};

}  // namespace meshops::detail

// What: what the engine may do with a front and others may not: to call out to a policy or a visitor while the front is
//       closed to changes, and to order its queue.
#pragma once

#include <span>

#include "meshops/front/front.h"

namespace meshops::detail {

class EngineSide {
 public:
  explicit EngineSide(Front& front) : front_(front) {}

  /// Returns: what the policy answers. While it is asked, whoever changes the front is refused.
  /// Throws:  what the policy throws; ContractViolation when it changed the mesh.
  template <typename Ask>
  auto ask(Ask question) const {
    const Call call(front_, Front::Caller::policy);
    auto answer = question();
    front_.require_intact();
    return answer;
  }

  /// The same of the visitor, which may activate and freeze edges.
  template <typename Tell>
  void tell(Tell event) const {
    const Call call(front_, Front::Caller::visitor);
    event();
    front_.require_intact();
  }

  /// The next in the queue that is active, and stays so; it is in no queue any more.
  Halfedge next_queued() const { return front_.next_queued(); }
  /// An active halfedge is so no longer. Returns: whether it was.
  bool take(Halfedge h) const { return front_.take(h); }
  /// After a throw: queues every active halfedge once. First the one in hand, if it is still to be asked about, then
  /// `next`, then what was queued, then all others. Nothing when the front is not intact.
  void requeue(Halfedge in_hand, std::span<const Halfedge> next) const { front_.requeue(in_hand, next); }

 private:
  /// As long as it lives.
  class Call {
   public:
    Call(Front& front, Front::Caller caller) : front_(front), before_(front.caller_) { front.caller_ = caller; }
    ~Call() { front_.caller_ = before_; }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

   private:
    Front& front_;
    Front::Caller before_;
  };
  Front& front_;
};

}  // namespace meshops::detail

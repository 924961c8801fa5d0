// What: a checkpoint that several threads may call.
#pragma once

#include <mutex>
#include <utility>

#include "rbpa/base/progress.h"

namespace rbpa {

/// A checkpoint for several threads: calls go_on(), one call at a time, and throws Cancelled in all threads after a
/// result of false.
class CheckpointOfThreads {
 public:
  /// Keeps a reference to `go_on`. An empty function is never called.
  explicit CheckpointOfThreads(const GoOn& go_on) : go_on_(go_on) {}
  void operator()() {
    if (!goes_on()) throw Cancelled();
  }
  /// Returns the result of go_on(), or false, without a call, once a result was false or go_on() has thrown.
  bool goes_on() {
    if (!go_on_) return true;
    const std::lock_guard<std::mutex> lock(one_call_);
    if (std::exchange(is_going_on_, false)) is_going_on_ = go_on_();
    return is_going_on_;
  }

 private:
  const GoOn& go_on_;
  bool is_going_on_ = true;
  std::mutex one_call_;
};

}  // namespace rbpa

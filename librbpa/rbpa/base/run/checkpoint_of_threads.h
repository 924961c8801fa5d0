// What: a checkpoint that several threads may call.
#pragma once

#include <exception>
#include <mutex>
#include <utility>

#include "rbpa/base/progress.h"

namespace rbpa {

/// A checkpoint for several threads: calls go_on(), one call at a time, and throws Cancelled in all threads after a
/// result of false. What go_on() throws is thrown in all threads, so that it does not matter which one ends first.
class CheckpointOfThreads {
 public:
  /// Keeps a reference to `go_on`. An empty function is never called.
  explicit CheckpointOfThreads(const GoOn& go_on) : go_on_(go_on) {}
  void operator()() {
    if (!goes_on()) throw Cancelled();
  }
  /// Returns the result of go_on(), or false, without a call, once a result was false. Rethrows, without a call, what
  /// go_on() has thrown or fail() was given.
  bool goes_on() {
    if (!go_on_) return true;
    const std::lock_guard<std::mutex> lock(one_call_);
    if (failure_) std::rethrow_exception(failure_);
    try {
      return is_going_on_ = is_going_on_ && go_on_();
    } catch (...) {
      failure_ = std::current_exception();
      throw;
    }
  }
  /// Makes the next calls in all threads throw the first failure of all. No effect if go_on is empty.
  void fail(std::exception_ptr failure) {
    const std::lock_guard<std::mutex> lock(one_call_);
    if (!failure_) failure_ = std::move(failure);
  }

 private:
  const GoOn& go_on_;
  bool is_going_on_ = true;
  std::exception_ptr failure_;
  std::mutex one_call_;
};

}  // namespace rbpa

// What: progress and cancellation of long computations.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>

#include "meshops/core/api.h"

namespace meshops {

/// Progress function: long computations call the function every few milliseconds, one call at a time, but possibly from
/// different threads of the computation. When the function returns false, the computation throws Cancelled. An empty
/// function is never called.
using GoOn = std::function<bool()>;

/// Exception by which a computation ends after the caller's progress function has returned false.
class MESHOPS_API Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Calls the function unless the function is empty. Throws Cancelled when the function returns false.
inline void stop_if_cancelled(const GoOn& go_on) {
  if (go_on && !go_on()) throw Cancelled();
}

/// Counter of loop steps. It calls the progress function once in about 16384 steps; a step is meant to take tens to
/// hundreds of nanoseconds.
class Steps {
 public:
  /// Keeps a reference to the function, which must outlive the counter. An empty function is never called.
  explicit Steps(const GoOn& go_on) : go_on_(go_on) {}
  explicit Steps(GoOn&&) = delete;  // it would not outlive the statement

  /// Counts `steps` more steps, and calls the function at most once. Throws Cancelled when the function returns false,
  /// and whatever the function throws.
  void operator()(std::size_t steps = 1) {
    if (left_ <= steps) return check();
    left_ -= steps;
  }

 private:
  void check() {
    left_ = interval;
    stop_if_cancelled(go_on_);
  }

  static constexpr std::size_t interval = 16384;
  const GoOn& go_on_;
  std::size_t left_ = interval;
};

}  // namespace meshops

// What: a checkpoint that several threads may call.
#pragma once

#include <mutex>

#include "rbpa/base/progress.h"

namespace rbpa {

/// A checkpoint for several threads: calls go_on(), one call at a time, and throws Cancelled after a result of false.
class CheckpointOfThreads {
 public:
  /// Keeps a reference to `go_on`. An empty function is never called.
  explicit CheckpointOfThreads(const GoOn& go_on) : go_on_(go_on) {}
  void operator()() {
    if (!go_on_) return;
    const std::lock_guard<std::mutex> lock(one_call_);
    stop_if_cancelled(go_on_);
  }

 private:
  const GoOn& go_on_;
  std::mutex one_call_;
};

}  // namespace rbpa

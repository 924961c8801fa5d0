// What: a function that decides whether to continue, made callable from several threads.
#pragma once

#include <mutex>

#include "rbpa/base/error.h"
#include "rbpa/base/progress.h"

namespace rbpa {

/// Calls the function from any thread, one call at a time. Throws: Cancelled.
class AskFromAnyThread {
 public:
  /// Keeps a reference. An empty function always continues.
  explicit AskFromAnyThread(const GoOn& go_on) : go_on_(go_on) {}
  void operator()() {
    if (!go_on_) return;
    const std::lock_guard<std::mutex> lock(asking_);
    if (!go_on_()) throw Cancelled();
  }

 private:
  const GoOn& go_on_;
  std::mutex asking_;
};

}  // namespace rbpa

// What: a caller's progress function as a function that returns whether to continue, for one thread or several.
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>

#include "rbpa/base/error.h"
#include "rbpa/base/progress.h"

namespace rbpa {

/// For the work before the first triangle or after the last: false ends it. Empty where `progress` is. Keeps a reference.
inline std::function<bool()> going_on(const std::function<bool(const Progress&)>& progress, std::size_t points,
                                      std::size_t triangles = 0) {
  if (!progress) return {};
  return [&progress, points, triangles] { return progress({triangles, points}); };
}

/// Calls the function from any thread, one call at a time. Throws: Cancelled.
class AskFromAnyThread {
 public:
  /// Keeps a reference. Empty: asks nobody.
  explicit AskFromAnyThread(const std::function<bool()>& go_on) : go_on_(go_on) {}
  void operator()() {
    if (!go_on_) return;
    const std::lock_guard<std::mutex> lock(asking_);
    if (!go_on_()) throw Cancelled();
  }

 private:
  const std::function<bool()>& go_on_;
  std::mutex asking_;
};

}  // namespace rbpa

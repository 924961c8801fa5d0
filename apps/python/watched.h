// What: a long computation without Python's lock: other threads of Python run on, Ctrl-C ends it, progress is reported.
// How:  the work has a thread of its own where it may take long. The calling one sleeps, and looks every few hundredths of
//       a second: only there may signals be checked, which Python allows its main thread alone, and only from there is
//       the caller's function called, which so may touch anything that belongs to that thread.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "rbpa/base/progress.h"

namespace rbpa::python {

namespace py = pybind11;

/// What the work and the thread that waits for it exchange.
class Watch {
 public:
  /// For the library's hooks. Good while the watch is.
  std::function<bool(const Progress&)> progress() {
    return [this](const Progress& now) {
      triangles_.store(now.triangles, std::memory_order_relaxed);
      points_.store(now.points, std::memory_order_relaxed);
      return go_on();
    };
  }
  std::function<bool()> until_stopped() {
    return [this] { return go_on(); };
  }

  bool go_on() const { return !stopped_.load(std::memory_order_relaxed); }
  void stop() { stopped_.store(true, std::memory_order_relaxed); }
  Progress last() const {
    return {triangles_.load(std::memory_order_relaxed), points_.load(std::memory_order_relaxed)};
  }

 private:
  std::atomic<bool> stopped_ = false;
  std::atomic<std::size_t> triangles_ = 0, points_ = 0;
};

/// Runs work(watch), in a thread of its own unless `is_short`; the calling thread holds Python's lock, and lets it go.
/// `progress` is None, or called as progress(triangles, points) every tenth of a second; what it raises, and what is false but None, ends
/// the work, and so does a signal whose handler raises.
/// Throws: what the work throws; Cancelled; what Python raised.
void run_watched(const std::function<void(Watch&)>& work, bool is_short, const py::object& progress);

/// The same with a result. Work on so many points or fewer is short.
template <typename Work>
auto watched(std::size_t points, const py::object& progress, Work work) {
  constexpr std::size_t few = 20'000;
  std::optional<decltype(work(std::declval<Watch&>()))> result;
  run_watched([&](Watch& watch) { result.emplace(work(watch)); }, points <= few, progress);
  return std::move(*result);
}

}  // namespace rbpa::python

// What: runs a long computation without Python's lock: other Python threads continue, Ctrl-C ends the computation, and
//       progress is reported.
// How:  work that may take long runs in a new thread. The calling thread sleeps, and wakes up every 20 ms to check
//       signals, which Python allows in its main thread only. It also calls the user's progress function, which may
//       therefore use objects that belong to the calling thread.
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

/// The data that the working and the waiting thread exchange. Both threads may use a Watch at any time.
class Watch {
 public:
  /// Return callbacks for the library, which store progress and end the run after stop(). They must not outlive the
  /// Watch.
  OnProgress progress() {
    return [this](const Progress& now) {
      triangles_.store(now.triangles, std::memory_order_relaxed);
      points_.store(now.points, std::memory_order_relaxed);
      return go_on();
    };
  }
  GoOn until_stopped() {
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

/// Runs work(watch), in a new thread unless `is_short`, and releases Python's lock meanwhile. In a new thread, calls
/// progress(triangles, points) about every 0.1 s, the first time after 0.02 s if the work has reported, unless
/// `progress` is None. The work ends early if `progress` or a signal handler raises, or if `progress` returns a false
/// value other than None.
/// Requires: the calling thread holds Python's lock.
/// Throws: the exceptions of the work, of a signal handler and of `progress`; Cancelled.
void run_watched(const std::function<void(Watch&)>& work, bool is_short, const py::object& progress);

/// The number of points to pass to watched() for work that may take long even on few points, such as closing holes.
inline constexpr std::size_t long_work = static_cast<std::size_t>(-1);

/// Runs work(watch) as run_watched() does, and returns its result. Work on at most 20,000 points counts as short.
template <typename Work>
auto watched(std::size_t points, const py::object& progress, Work work) {
  constexpr std::size_t few = 20'000;
  std::optional<decltype(work(std::declval<Watch&>()))> result;
  run_watched([&](Watch& watch) { result.emplace(work(watch)); }, points <= few, progress);
  return std::move(*result);
}

}  // namespace rbpa::python

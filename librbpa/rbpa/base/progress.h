// What: the limit on the threads of a run, and the callbacks that report its progress and can cancel it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "rbpa/base/error.h"

namespace rbpa {

/// Maximum number of threads of a run, the calling one included; 0: one for each processor. A run never uses more
/// threads than there are processors. Results do not depend on the number of threads.
using MaxThreads = unsigned;

/// Counts that show the progress of a run.
struct Progress {
  std::size_t triangles;  ///< number of triangles found, unless a function documents another count
  std::size_t points;     ///< number of input points, or of distinct points once duplicates are known
};

/// Callback that a run calls every few milliseconds unless the function documents other intervals, one call at a time,
/// from any thread of the run. If it returns false, the run ends with Cancelled. An empty callback is never called.
using OnProgress = std::function<bool(const Progress&)>;
/// Callback like OnProgress, but without an argument (meshops/core/progress.h).
using meshops::GoOn;
using meshops::stop_if_cancelled;
/// Callback that a run calls every few milliseconds, and that throws Cancelled to end the run. An empty callback is
/// never called.
using Checkpoint = std::function<void()>;

/// Calls `progress` with `counts`, unless `progress` is empty. Throws Cancelled when `progress` returns false.
inline void stop_if_cancelled(const OnProgress& progress, const Progress& counts) {
  if (progress && !progress(counts)) throw Cancelled();
}

/// Returns a function that calls `progress` with the given counts, and returns whether to continue. The result is empty
/// if `progress` is empty; otherwise it keeps a reference to `progress`.
inline GoOn go_on_of(const OnProgress& progress, std::size_t points, std::size_t triangles = 0) {
  if (!progress) return {};
  return [&progress, points, triangles] { return progress({triangles, points}); };
}

/// Returns a callback that passes the greatest number of triangles of all its calls on to `progress`, so that the
/// reported number never falls. The result is empty if `progress` is empty; otherwise it keeps a reference to
/// `progress`. Each copy of the result counts separately.
inline OnProgress rising(const OnProgress& progress) {
  if (!progress) return {};
  return [&progress, most = std::size_t{0}](const Progress& now) mutable {
    most = std::max(most, now.triangles);
    return progress({most, now.points});
  };
}

/// Returns a callback that ignores the counts and calls `go_on`. The result is empty if `go_on` is empty; otherwise it
/// keeps a reference to `go_on`.
inline OnProgress on_progress_of(const GoOn& go_on) {
  if (!go_on) return {};
  return [&go_on](const Progress&) { return go_on(); };
}

/// Returns a function that throws Cancelled when `go_on` returns false. The result is empty if `go_on` is empty.
inline Checkpoint checkpoint_of(GoOn go_on) {
  if (!go_on) return {};
  return [go_on = std::move(go_on)] { stop_if_cancelled(go_on); };
}
/// Returns a function that calls `progress` with the given counts, and throws Cancelled when `progress` returns false.
/// The result is empty if `progress` is empty; otherwise it keeps a reference to `progress`.
inline Checkpoint checkpoint_of(const OnProgress& progress, std::size_t points, std::size_t triangles = 0) {
  return checkpoint_of(go_on_of(progress, points, triangles));
}

}  // namespace rbpa

// What: how a run is carried out: its threads, and the callbacks that see its progress and can cancel it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "rbpa/base/error.h"

namespace rbpa {

/// Maximum number of threads of a run, the calling one included; never more are used than there are processors. 0 means
/// one for each processor. Results do not depend on the number of threads.
using MaxThreads = unsigned;

/// Counts that show how far a run is.
struct Progress {
  std::size_t triangles;  ///< number of triangles so far, unless a function says otherwise
  std::size_t points;     ///< number of all points; of the distinct ones where duplicates are known
};

/// Callback that is called every few milliseconds unless a function says otherwise, one call at a time but from any
/// thread of the run. Returning false ends the run with Cancelled. An empty callback is never called.
using OnProgress = std::function<bool(const Progress&)>;
/// Callback as OnProgress, but without an argument (meshops/core/progress.h).
using meshops::GoOn;
using meshops::stop_if_cancelled;
/// Function that a run calls every few milliseconds, and that throws Cancelled to end the run. Never called if empty.
using Checkpoint = std::function<void()>;

/// Calls `progress` with these counts, unless it is empty. Throws Cancelled when it returns false.
inline void stop_if_cancelled(const OnProgress& progress, const Progress& counts) {
  if (progress && !progress(counts)) throw Cancelled();
}

/// Returns a function that calls `progress` with these counts, and returns whether to continue. The result is empty if
/// `progress` is; else it keeps a reference to `progress`.
inline GoOn go_on_of(const OnProgress& progress, std::size_t points, std::size_t triangles = 0) {
  if (!progress) return {};
  return [&progress, points, triangles] { return progress({triangles, points}); };
}

/// Returns a callback that calls `progress` with the greatest number of triangles so far, so that it never falls. The
/// result is empty if `progress` is; else it keeps a reference to `progress`, and copies of it count apart.
inline OnProgress rising(const OnProgress& progress) {
  if (!progress) return {};
  return [&progress, most = std::size_t{0}](const Progress& now) mutable {
    most = std::max(most, now.triangles);
    return progress({most, now.points});
  };
}

/// Returns a function that ignores the counts and calls `go_on`. The result is empty if `go_on` is; else it keeps a
/// reference to `go_on`.
inline OnProgress on_progress_of(const GoOn& go_on) {
  if (!go_on) return {};
  return [&go_on](const Progress&) { return go_on(); };
}

/// Returns a function that throws Cancelled when `go_on` returns false. The result is empty if `go_on` is.
inline Checkpoint checkpoint_of(GoOn go_on) {
  if (!go_on) return {};
  return [go_on = std::move(go_on)] { stop_if_cancelled(go_on); };
}
/// Returns a function that calls `progress` with these counts, and throws Cancelled when it returns false. The result
/// is empty if `progress` is; else it keeps a reference to `progress`.
inline Checkpoint checkpoint_of(const OnProgress& progress, std::size_t points, std::size_t triangles = 0) {
  return checkpoint_of(go_on_of(progress, points, triangles));
}

}  // namespace rbpa

// What: how a run is carried out: its threads, and the callbacks that see its progress and can cancel it.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "rbpa/base/error.h"

namespace rbpa {

/// Maximum number of threads of a run, the calling one included. 0 = all processors; larger values are capped. Results
/// do not depend on it.
using MaxThreads = unsigned;

/// The number of triangles attached so far, and the number of distinct points (of all points until duplicates are
/// found).
struct Progress {
  std::size_t triangles;
  std::size_t points;
};

/// Callback that is called every few milliseconds, one call at a time but from any thread of the run. Returning false
/// ends the run with Cancelled. An empty one is never called.
using OnProgress = std::function<bool(const Progress&)>;
/// The same without the progress; libmeshops shares it.
using meshops::GoOn;
/// Function that throws Cancelled to end the run; it is called as often.
using Ask = std::function<void()>;

/// Returns `progress` as a function without arguments that returns whether to continue, for the work before the first
/// triangle or after the last. The result is empty if `progress` is. Keeps a reference.
inline GoOn going_on(const OnProgress& progress, std::size_t points, std::size_t triangles = 0) {
  if (!progress) return {};
  return [&progress, points, triangles] { return progress({triangles, points}); };
}

/// Returns a function that throws Cancelled when `go_on` returns false; the result is empty if `go_on` is.
inline Ask asking(GoOn go_on) {
  if (!go_on) return {};
  return [go_on = std::move(go_on)] {
    if (!go_on()) throw Cancelled();
  };
}
/// Returns a function that throws Cancelled when `progress` returns false. Keeps a reference.
inline Ask asking(const OnProgress& progress, std::size_t points, std::size_t triangles = 0) {
  return asking(going_on(progress, points, triangles));
}

}  // namespace rbpa

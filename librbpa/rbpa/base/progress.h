// What: the progress of a run, and the callback that can cancel it.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "rbpa/base/error.h"

namespace rbpa {

/// The number of triangles attached so far, and the number of distinct points (of all points until duplicates are
/// found).
struct Progress {
  std::size_t triangles;
  std::size_t points;
};

/// Returns `progress` as a function without arguments that returns whether to continue, for the work before the first
/// triangle or after the last. The result is empty if `progress` is. Keeps a reference.
inline std::function<bool()> going_on(const std::function<bool(const Progress&)>& progress, std::size_t points,
                                      std::size_t triangles = 0) {
  if (!progress) return {};
  return [&progress, points, triangles] { return progress({triangles, points}); };
}

/// Returns a function that throws Cancelled when `go_on` returns false; the result is empty if `go_on` is.
inline std::function<void()> asking(std::function<bool()> go_on) {
  if (!go_on) return {};
  return [go_on = std::move(go_on)] {
    if (!go_on()) throw Cancelled();
  };
}
/// Returns a function that throws Cancelled when `progress` returns false. Keeps a reference.
inline std::function<void()> asking(const std::function<bool(const Progress&)>& progress, std::size_t points,
                                    std::size_t triangles = 0) {
  return asking(going_on(progress, points, triangles));
}

}  // namespace rbpa

// What: the progress of a run, and the callback that can cancel it.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "rbpa/base/error.h"

namespace rbpa {

/// Triangles attached so far, and distinct points (all points until duplicates are found).
struct Progress {
  std::size_t triangles;
  std::size_t points;
};

/// Returns `progress` as a function of no arguments, for the work before the first triangle or after the last: it returns
/// whether to continue. Empty where `progress` is. Keeps a reference.
inline std::function<bool()> going_on(const std::function<bool(const Progress&)>& progress, std::size_t points,
                                      std::size_t triangles = 0) {
  if (!progress) return {};
  return [&progress, points, triangles] { return progress({triangles, points}); };
}

/// Returns a function that throws Cancelled where `go_on` returns false; empty where `go_on` is.
inline std::function<void()> asking(std::function<bool()> go_on) {
  if (!go_on) return {};
  return [go_on = std::move(go_on)] {
    if (!go_on()) throw Cancelled();
  };
}
/// Likewise of going_on(progress, points, triangles). Keeps a reference.
inline std::function<void()> asking(const std::function<bool(const Progress&)>& progress, std::size_t points,
                                    std::size_t triangles = 0) {
  return asking(going_on(progress, points, triangles));
}

}  // namespace rbpa

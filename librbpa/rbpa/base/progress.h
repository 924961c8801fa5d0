// What: the progress of a run, and the callback that can cancel it.
#pragma once

#include <cstddef>
#include <functional>

#include "rbpa/base/error.h"

namespace rbpa {

/// Triangles attached so far, and distinct points (all points until duplicates are found).
struct Progress {
  std::size_t triangles;
  std::size_t points;
};

/// For the work before the first triangle or after the last: calls `progress`, and throws Cancelled if that returns false;
/// empty where `progress` is. Keeps a reference.
inline std::function<void()> asking(const std::function<bool(const Progress&)>& progress, std::size_t points,
                                    std::size_t triangles = 0) {
  if (!progress) return {};
  return [&progress, points, triangles] {
    if (!progress({triangles, points})) throw Cancelled();
  };
}

}  // namespace rbpa

// What: how far a run has come, and how those who watch it are asked whether it goes on.
#pragma once

#include <cstddef>
#include <functional>

#include "rbpa/base/error.h"

namespace rbpa {

/// Triangles attached so far, and distinct points (all points until these are known).
struct Progress {
  std::size_t triangles;
  std::size_t points;
};

/// For what comes before the first triangle or after the last: asks, and throws Cancelled; empty where `progress` is. Keeps
/// a reference.
inline std::function<void()> asking(const std::function<bool(const Progress&)>& progress, std::size_t points,
                                    std::size_t triangles = 0) {
  if (!progress) return {};
  return [&progress, points, triangles] {
    if (!progress({triangles, points})) throw Cancelled();
  };
}

}  // namespace rbpa

// What: how far a run has come.
#pragma once

#include <cstddef>

namespace rbpa {

/// Triangles attached so far, and distinct points (all points until these are known).
struct Progress {
  std::size_t triangles;
  std::size_t points;
};

}  // namespace rbpa

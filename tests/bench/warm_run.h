// What: measures computing in memory that a process has already, without the cost of fresh pages.
#pragma once

#include <cstddef>
#include <string>

namespace rbpa_bench {

struct WarmRun {
  double seconds = 0, processor_seconds = 0;  ///< seconds of the last of three runs
  std::size_t triangles = 0;
};

/// Computes triangles of the points of a file, as arrays with neighbors, and on request their polygons, in a process of
/// its own. Throws std::runtime_error when that fails.
WarmRun compute_warm(const std::string& file, double alpha, unsigned threads, bool with_polygons);

}  // namespace rbpa_bench

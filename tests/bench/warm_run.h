// What: computing in memory that a process has already: the rate that is left when nobody pays for fresh pages.
#pragma once

#include <cstddef>
#include <string>

namespace rbpa_bench {

struct WarmRun {
  double seconds = 0, processor_seconds = 0;  ///< of the last of three
  std::size_t triangles = 0;
};

/// Triangles of the points of a file, as arrays with neighbors, and polygons of them on request, in a process
/// of its own. Throws std::runtime_error when that fails.
WarmRun compute_warm(const std::string& file, double alpha, unsigned threads, bool with_polygons);

}  // namespace rbpa_bench

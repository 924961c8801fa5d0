// What: runs a program and watches its time, its memory, and its files on disk.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rbpa_bench {

/// State at one moment of a run.
struct Moment {
  double seconds = 0;            ///< since the start
  double processor_seconds = 0;  ///< processor time of all its threads
  double resident_bytes = 0;
  double tile_bytes = 0, scratch_bytes = 0;  ///< sizes of tile files, and of all files in the scratch folder
};

struct WatchedRun {
  double seconds = 0, processor_seconds = 0;
  double peak_bytes = 0;             ///< peak of resident memory, as the system reports at the end
  std::vector<Moment> moments = {};  ///< ascending in time; watching takes less than a hundredth of the time

  /// Returns the processor time that its threads had used after `seconds`.
  double processor_seconds_at(double seconds) const;
};

/// Runs the command, whose first word is the program, and waits. `scratch` may be empty. Throws std::runtime_error when
/// the exit code is not 0.
WatchedRun run_watched(const std::vector<std::string>& command, const std::string& scratch);

}  // namespace rbpa_bench

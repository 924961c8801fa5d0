// What: a program as a process that is watched: its time, its memory, and what it has on disk.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rbpa_bench {

/// At a moment of a run.
struct Moment {
  double seconds = 0;            ///< since it began
  double processor_seconds = 0;  ///< of all its threads
  double resident_bytes = 0;
  double tile_bytes = 0, scratch_bytes = 0;  ///< of files of tiles, and of all files of the scratch
};

struct WatchedRun {
  double seconds = 0, processor_seconds = 0;
  double peak_bytes = 0;             ///< of resident memory, as the system reports at its end
  std::vector<Moment> moments = {};  ///< ascending; looking takes less than a hundredth of the time

  /// What its threads had used by then.
  double processor_seconds_at(double seconds) const;
};

/// Runs the command, the program first, and waits. `scratch` may be empty. Throws std::runtime_error when it ends with
/// anything but 0.
WatchedRun run_watched(const std::vector<std::string>& command, const std::string& scratch);

}  // namespace rbpa_bench

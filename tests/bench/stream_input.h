// What: makes the files that bench_stream gives to the programs, and measures plain reading and writing of the same
//       amount.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/lidar_points.h"

namespace rbpa_bench {

struct PointFiles {
  std::vector<std::string> paths;
  double bytes = 0;
};

/// Required contents of the files.
struct Wanted {
  Ground ground;
  std::uint64_t points, seed;
  std::string format;  ///< "f64xy" or "npy"
  std::size_t files;
};

/// Makes files in `folder`, and the folder; matching files of an earlier run are used again. They are on the disk when
/// this returns. Throws std::runtime_error.
PointFiles write_files(const Wanted& wanted, const std::string& folder);

/// Advises the system to drop the files from its cache. Returns: the share of them that stays.
double forget(const PointFiles& files);

/// Returns the seconds that the reader of `rbpa stream` takes for all points of the files, in one thread.
double seconds_to_read(const PointFiles& files);

/// Returns the seconds to write that many bytes to a file on the disk.
double seconds_to_write(const std::string& path, double bytes);

}  // namespace rbpa_bench

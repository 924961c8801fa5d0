// What: the files that bench_stream gives to the programs, and what reading and writing so much takes by itself.
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

/// What the files have.
struct Wanted {
  Ground ground;
  std::uint64_t points, seed;
  std::string format;  ///< "f64xy" or "npy"
  std::size_t files;
};

/// Files in `folder`, which is made; those of an earlier run are used again where they are the same. They are on the disk
/// when this returns. Throws std::runtime_error.
PointFiles write_files(const Wanted& wanted, const std::string& folder);

/// Advises the system to keep nothing of the files in memory. Returns: the share of them that stays all the same.
double forget(const PointFiles& files);

/// Seconds in which the reader of `rbpa stream` gives all points of the files, one thread.
double seconds_to_read(const PointFiles& files);

/// Seconds in which so many bytes are written to a file and on the disk.
double seconds_to_write(const std::string& path, double bytes);

}  // namespace rbpa_bench

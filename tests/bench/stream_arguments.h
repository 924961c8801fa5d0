// What: the arguments of bench_stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "bench/lidar_points.h"

namespace rbpa_bench {

struct StreamArguments {
  std::uint64_t points = 10'000'000;
  std::uint64_t in_memory = 20'000'000;  ///< at most so many in the run that has all in memory
  std::string memory = "1G";
  double alpha = 2;  ///< the mean spacing is 1
  unsigned threads = 2;
  std::size_t files = 8;
  std::uint64_t seed = 1;
  Ground ground = Ground::jittered;
  std::string input = "f64xy";     ///< or npy
  std::string target = "geojson";  ///< or wkt, npy
  std::string scratch = ".";
  std::string trace = {};    ///< the file of moments, or none
  std::string program = {};  ///< rbpa; the one beside this
  bool keep = false;         ///< the input, for one more run on it
};

/// Nothing, and the usage on standard error, when there is one that is none.
std::optional<StreamArguments> parse_stream(int argc, char** argv);

}  // namespace rbpa_bench

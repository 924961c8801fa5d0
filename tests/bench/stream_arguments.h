// What: reads the arguments of bench_stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "bench/lidar_points.h"

namespace rbpa_bench {

struct StreamArguments {
  std::uint64_t points = 10'000'000;
  std::uint64_t in_memory = 20'000'000;  ///< largest number of points for the run in memory
  std::string memory = "1G";
  double alpha = 2;  ///< the mean spacing is 1
  unsigned threads = 2;
  std::size_t files = 8;
  std::uint64_t seed = 1;
  Ground ground = Ground::jittered;
  std::string input = "f64xy";     ///< "f64xy" or "npy"
  std::string target = "geojson";  ///< "geojson", "wkt" or "npy"
  std::string scratch = ".";
  std::string trace = {};    ///< file for the moments of the run; empty: none
  std::string program = {};  ///< path of rbpa; empty: the one beside this program
  bool keep = false;         ///< keep the input for another run
};

/// Parses the command line. Returns: nothing, after printing the usage on standard error, when an argument is unknown.
std::optional<StreamArguments> parse_stream(int argc, char** argv);

}  // namespace rbpa_bench

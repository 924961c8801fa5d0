// What: reads the command line of bench_report.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rbpa_bench {

struct ReportArguments {
  struct Peer {
    std::string name, command;
  };
  std::size_t points = 1000000;
  std::size_t trap_points = 100000;  ///< 0 for no traps
  int runs = 5;
  std::vector<unsigned> threads{1, 2};  ///< the first is the reference for all others
  std::vector<Peer> peers;
  bool check = false;  ///< compare sets of triangles, not only their numbers
  bool large = false;  ///< also measure sixteen times the points
};

/// Parses the command line. Returns: nothing, after printing the usage on standard error, when there is anything else.
std::optional<ReportArguments> parse_report(int argc, char** argv);

}  // namespace rbpa_bench

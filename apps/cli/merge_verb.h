// What: `rbpa merge`: partials of `rbpa tile` become one, or the files that the run is for.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rbpa::app {

/// What the command line says, as text.
struct MergeArguments {
  std::vector<std::string> partials;
  std::vector<std::string> outputs;
  std::optional<std::string> output_format;
  std::optional<std::string> stats;
  std::string memory = "1G";
  std::optional<std::string> scratch;
  bool quiet = false;
};

constexpr const char* merge_formats = "partial, or of all tiles geojson, json, wkt, npy";

/// Throws what run() of exit_code.h turns into an exit code.
void run_merge(const MergeArguments& arguments);

}  // namespace rbpa::app

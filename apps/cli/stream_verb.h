// What: `rbpa stream`: triangles and polygons of more points than fit into memory.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/alpha_choice.h"
#include "cli/point_arguments.h"
#include "cli/run_options.h"

namespace rbpa::app {

/// What the command line says, as text.
struct StreamArguments : PointArguments {
  std::vector<std::string> inputs;  ///< files, and folders of files; `points` is each of them in turn
  RadiusArguments radius;
  std::vector<std::string> outputs;
  std::optional<std::string> output_format;
  std::optional<std::string> stats;
  std::string memory = "1G";
  std::optional<std::string> tile_size;
  std::optional<std::string> scratch;
  std::optional<std::string> tasks;
  std::string program = "rbpa";  ///< as it was called
  bool keep_tiles = false;
  bool resume = false;
  RunArguments run;
};

/// Throws what run() of exit_code.h turns into an exit code.
void run_stream(const StreamArguments& arguments);

}  // namespace rbpa::app

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
  bool keep_tiles = false;
  bool resume = false;
  RunArguments run;
};

constexpr std::string_view stream_formats = "geojson, json, wkt, npy, or ply where the name has a '*'";

/// Throws what run() of exit_code.h turns into an exit code.
void run_stream(const StreamArguments& arguments);

}  // namespace rbpa::app

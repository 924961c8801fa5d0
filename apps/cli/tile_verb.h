// What: `rbpa tile`: the task of one tile that `rbpa stream --tasks` has cut.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/run_options.h"

namespace rbpa::app {

/// What the command line says, as text.
struct TileArguments {
  std::string tile;
  std::vector<std::string> outputs;
  std::optional<std::string> stats;
  RunArguments run;
};

constexpr const char* tile_formats = "partial, npy (its triangles), ply (its mesh)";

/// Throws what run() of exit_code.h turns into an exit code.
void run_tile(const TileArguments& arguments);

}  // namespace rbpa::app

// What: `rbpa info`: what a file of points holds.
#pragma once

#include <optional>
#include <string>

#include "cli/point_arguments.h"

namespace rbpa::app {

struct InfoArguments : PointArguments {
  std::optional<std::string> stats;
  bool json = false;
  bool quiet = false;  ///< taken like by the other verbs; there is nothing to leave out
};

/// Prints to standard output. Throws as run_mesh() does.
void run_info(const InfoArguments& arguments);

}  // namespace rbpa::app

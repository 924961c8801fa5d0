// What: `rbpa info`: what a file of points holds.
#pragma once

#include <optional>
#include <string>

#include "cli/pixel_arguments.h"

namespace rbpa::app {

struct InfoArguments {
  std::string points;
  std::optional<std::string> format;
  std::optional<std::string> columns;
  PixelArguments pixels;
  std::optional<std::string> stats;
  bool json = false;
  bool quiet = false;  ///< taken like by the other verbs; there is nothing to leave out
};

/// Prints to standard output. Throws as run_mesh() does.
void run_info(const InfoArguments& arguments);

}  // namespace rbpa::app

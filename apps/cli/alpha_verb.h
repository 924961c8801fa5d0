// What: `rbpa alpha`: the radii at which the complex of a set of points changes, and which of them to choose.
#pragma once

#include <optional>
#include <string>

#include "cli/pixel_arguments.h"
#include "cli/run_options.h"

namespace rbpa::app {

struct AlphaArguments {
  std::string points;
  std::optional<std::string> format;
  std::optional<std::string> columns;
  PixelArguments pixels;
  std::optional<std::string> stats;
  std::optional<std::string> picture;  ///< an .svg to write
  std::string components = "1";        ///< at most, at `auto`
  std::optional<std::string> cover;    ///< share of the points, at `auto` and `min`
  bool json = false;
  bool csv = false;
  bool persistence = false;
  std::optional<std::string> complex;  ///< whose persistence: solid (as if absent) or full
  RunArguments run;
};

/// Prints to standard output. Throws as run_mesh() does.
void run_alpha(const AlphaArguments& arguments);

}  // namespace rbpa::app

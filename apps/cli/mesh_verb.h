// What: `rbpa mesh`: from a file of points to files of triangles and pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/method.h"
#include "cli/pixel_arguments.h"
#include "cli/run_options.h"
#include "io/columns.h"
#include "io/formats.h"
#include "rbpa/rbpa.h"

namespace rbpa::app {

/// What the command line says, as text; run_mesh() judges it.
struct MeshArguments {
  std::string points;
  std::optional<std::string> format;
  std::optional<std::string> columns;
  PixelArguments pixels;
  std::string alpha;
  std::optional<std::string> components;  ///< at most, at `auto`; 1 if absent
  std::vector<std::string> outputs;
  std::optional<std::string> output_format;
  std::optional<std::string> stats;
  std::optional<std::string> levels;
  MethodArguments method;
  std::string width = "1200";
  bool compact = false;
  RunArguments run;
};

/// Throws WrongUsage before anything is read; BadInput, Failure, Cancelled. No file is left behind then.
void run_mesh(const MeshArguments& arguments);

}  // namespace rbpa::app

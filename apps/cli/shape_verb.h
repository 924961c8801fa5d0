// What: `rbpa shape`: from a file of points to files of polygons and pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/method.h"
#include "cli/pixel_arguments.h"
#include "cli/run_options.h"

namespace rbpa::app {

/// What the command line says, as text; run_shape() judges it.
struct ShapeArguments {
  std::string points;
  std::optional<std::string> format;
  std::optional<std::string> columns;
  PixelArguments pixels;
  std::string alpha;
  std::optional<std::string> components;  ///< at most, at `auto`; 1 if absent
  std::vector<std::string> outputs;
  std::optional<std::string> output_format;
  std::optional<std::string> stats;
  MethodArguments method;
  std::string min_hole_area = "0";
  std::string min_part_area = "0";
  std::string width = "1200";
  RunArguments run;
};

/// Throws WrongUsage before anything is read; BadInput, Failure, Cancelled. No file is left behind then.
void run_shape(const ShapeArguments& arguments);

}  // namespace rbpa::app

// What: `rbpa shape`: from a file of points to files of polygons and pictures.
#pragma once

#include <optional>
#include <string>

#include "cli/complex_run.h"

namespace rbpa::app {

/// What the command line says, as text; run_shape() judges it.
struct ShapeArguments : ComplexArguments {
  std::string min_hole_area = "0";
  std::string min_part_area = "0";
  std::optional<std::string> isolated;  ///< a file for the points in no polygon
};

/// Throws WrongUsage before anything is read; BadInput, Failure, Cancelled. No file is left behind then.
void run_shape(const ShapeArguments& arguments);

}  // namespace rbpa::app

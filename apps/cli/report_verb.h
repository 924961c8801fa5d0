// What: `rbpa report`: a page that shows the complex of a set of points at every radius.
#pragma once

#include <optional>
#include <string>

#include "cli/point_arguments.h"
#include "cli/run_options.h"

namespace rbpa::app {

struct ReportArguments : PointArguments {
  std::optional<std::string> stats;
  std::string output;                ///< an .html to write, or "-"
  std::string components = "1";      ///< at most, at `auto`
  std::optional<std::string> cover;  ///< share of the points, at `auto` and `min`
  RunArguments run;
};

/// Throws as run_mesh() does.
void run_report(const ReportArguments& arguments);

}  // namespace rbpa::app

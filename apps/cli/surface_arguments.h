// What: the command line of `rbpa surface`, from text to meaning.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/arguments.h"
#include "cli/run_options.h"
#include "io/cloud/read_space_points.h"

namespace rbpa::app {

/// What the command line says, as text; parse() judges it.
struct SurfaceArguments {
  std::string points;  ///< the file
  std::optional<std::string> format;
  std::optional<std::string> columns;
  std::optional<std::string> where;
  bool skip_invalid = false;
  std::string radius;
  std::optional<std::string> normals;
  std::vector<std::string> outputs;
  std::optional<std::string> output_format;
  std::optional<std::string> holes;
  std::optional<std::string> stats;
  std::string width = "1200";
  bool compact = false;
  bool json = false;
  RunArguments run;
};

enum class NormalSource { file, estimate, none };

struct SurfaceRequest {
  std::string path;
  Format format;
  CloudRequest choice;
  std::vector<double> radii;            ///< empty: auto
  std::optional<NormalSource> normals;  ///< absent: of the file if it has any, else estimated
  std::vector<Target> targets;
  int width;
  RunOptions run;
};

/// Throws WrongUsage naming the value.
SurfaceRequest parse(const SurfaceArguments& arguments);

}  // namespace rbpa::app

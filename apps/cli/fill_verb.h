// What: `rbpa fill`: from a file of polygons to files of triangles and pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rbpa::app {

/// What the command line says, as text; run_fill() judges it.
struct FillArguments {
  std::string polygons;  ///< the file
  std::optional<std::string> format;
  std::string size;
  std::optional<std::string> size_at;
  std::optional<std::string> grade;
  bool keep_boundary = false;
  bool skip_invalid = false;
  std::vector<std::string> outputs;
  std::optional<std::string> output_format;
  std::optional<std::string> stats;
  std::string width = "1200";
  bool quiet = false;
};

/// Throws WrongUsage before anything is read; BadInput, Failure, Cancelled. No file is left behind then.
void run_fill(const FillArguments& arguments);

}  // namespace rbpa::app

// What: what the verbs share that make a complex of points: from the command line to points and a radius, and what is told
//       of a run when it is done.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/alpha_choice.h"
#include "cli/method.h"
#include "cli/point_arguments.h"
#include "cli/run_options.h"
#include "cli/stats.h"
#include "io/bytes/output_file.h"
#include "io/cloud/read_points.h"

namespace rbpa::app {

/// What the command line says, as text.
struct ComplexArguments : PointArguments {
  RadiusArguments radius;
  std::vector<std::string> outputs;
  std::optional<std::string> output_format;
  std::optional<std::string> stats;
  MethodArguments method;
  std::string width = "1200";
  RunArguments run;
};

/// What it means.
struct ComplexRequest {
  PointSource source;
  AlphaChoice alpha;
  Method method;
  RunOptions options;
  int width;                         ///< of pictures
  std::optional<std::string> stats;  ///< the file for them
  bool shows_writing;                ///< a line while files are written
  double bytes_a_point = 0;          ///< of memory that the run takes beyond the points; 0: that is not compared
};

/// Throws WrongUsage naming the value, before anything is read.
ComplexRequest parse_request(const ComplexArguments& arguments);

/// A run on its way.
struct ComplexRun {
  ComplexRequest request;
  Stopwatch watch = {};
  std::vector<Point> points = {};
  std::optional<Crs> crs = std::nullopt;  ///< of the points, where it is known
  bool degrees = false;                   ///< they are longitudes and latitudes
  double alpha = 0;                       ///< that was given, or that the points have chosen
  Stats stats = {};                       ///< what is known so far
};

/// Reads the points and lets them choose the radius where a rule says so. Throws BadInput, Failure, Cancelled.
ComplexRun begin_run(ComplexRequest request);

/// Writes the report, if there is to be one, and gives all files their names. Throws Failure, Cancelled.
void end_run(ComplexRun& run, OutputSet& outputs);

/// Why the complex of so many distinct points has no triangle: "no triangle has circumradius <= 0.5".
std::string why_empty(const ComplexRun& run, std::size_t distinct);

/// Unless quiet: "5 points (1 duplicate), MADE, alpha auto = 0.5 -> TARGETS".
void say_summary(const ComplexRun& run, std::size_t duplicates, const std::string& made, const std::string& targets);

}  // namespace rbpa::app

// What: what the verbs share that make a complex of points: from the command line to points and a radius, and what is said
//       of a run when it is done.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/alpha_choice.h"
#include "cli/method.h"
#include "cli/point_arguments.h"
#include "cli/run.h"
#include "cli/stats.h"

namespace rbpa::app {

/// What the command line says, as text.
struct ComplexArguments : PointArguments, GroupArguments, OutputArguments {
  RadiusArguments radius;
  MethodArguments method;
  std::string width = "1200";
  RunArguments run;
};

/// What it means.
struct ComplexRequest {
  RunOptions options;
  PointSource source;
  AlphaChoice alpha;
  Method method;
  int width;                 ///< of pictures
  double bytes_a_point = 0;  ///< of memory that the run takes beyond the points; 0: that is not compared
};

/// Throws WrongUsage naming the value, before anything is read. Of groups the source is that of the first file.
ComplexRequest parse_request(const ComplexArguments& arguments, ChosenFor chosen_for = ChosenFor::all_points);

/// A run whose points are read.
struct ComplexRun : Run {
  /// Reads them and lets them choose the radius where a rule says so. Throws BadInput, Failure, Cancelled.
  ComplexRun(const ComplexRequest& wanted, const OutputArguments& arguments);

  /// Writes the report, if there is to be one, and gives all files their names. Throws Failure, Cancelled.
  void finish();
  /// Why the complex of so many distinct points has no triangle: "no triangle has circumradius <= 0.5".
  std::string why_empty(std::size_t distinct) const;
  /// Says, unless quiet: "5 points (1 duplicate), MADE, alpha auto = 0.5 -> TARGETS".
  void summarize(std::size_t duplicates, const std::string& made, const std::string& targets) const;

  ComplexRequest request;
  std::optional<std::string> stats_file;
  PointFile file;
  const std::vector<Point>& points() const { return file.points; }
  double alpha = 0;  ///< that was given, or that the points have chosen
  Stats stats = {};  ///< what is known so far
};

}  // namespace rbpa::app

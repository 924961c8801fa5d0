// What: the steps that all verbs which make a complex of points have in common: they parse the command line, read the
//       points, choose the radius, and print a summary at the end.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "shared/alpha_option.h"
#include "shared/method.h"
#include "shared/point_arguments.h"
#include "shared/run.h"
#include "shared/stats.h"

namespace rbpa::app {

/// The command line, as text.
struct ComplexArguments : PointArguments, GroupArguments, OutputArguments {
  RadiusArguments radius;
  MethodArguments method;
  std::string width = "1200";
  RunArguments run;
};

/// The command line, parsed.
struct ComplexRequest {
  RunOptions options;
  PointSource source;
  AlphaOption alpha;
  Method method;
  int width;                 ///< of pictures, in pixels
  double bytes_a_point = 0;  ///< memory that the run takes beyond the points, in bytes for each; 0: not checked
};

/// Parses the command line, before anything is read. For groups the source is the first file. Throws WrongUsage that
/// names the value.
ComplexRequest parse_request(const ComplexArguments& arguments, ChosenFor chosen_for = ChosenFor::all_points);

/// A run of a verb that makes a complex, with its points and its radius.
struct ComplexRun : Run {
  /// Reads all points of the file, and chooses the radius if a rule is given. Throws BadInput, Failure, Cancelled.
  ComplexRun(const ComplexRequest& wanted, const OutputArguments& arguments);

  /// Writes the report if one is requested, and gives all files their names. Throws Failure, Cancelled.
  void finish();
  /// Returns why the complex of `distinct` points has no triangle: "no triangle has circumradius <= 0.5".
  std::string why_empty(std::size_t distinct) const;
  /// Prints, unless quiet: "5 points (1 duplicate), MADE, alpha auto = 0.5 -> TARGETS".
  void summarize(std::size_t duplicates, const std::string& made, const std::string& targets) const;

  ComplexRequest request;
  std::optional<std::string> stats_file;
  PointFile file;
  const std::vector<Point>& points() const { return file.points; }
  double alpha = 0;  ///< given, or chosen by a rule
  Stats stats = {};  ///< filled in as the run goes
};

}  // namespace rbpa::app

// What: runs the steps of all verbs that make a complex of points: parses the command line, reads the points, chooses
//       the radius, and prints a summary at the end.
#pragma once

#include <cstddef>
#include <functional>
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
};

/// The parsed command line.
struct ComplexRequest {
  RunOptions options;
  PointSource source;
  AlphaOption alpha;
  Method method;
  int width;  ///< width of pictures, in pixels
  double bytes_a_point =
      0;  ///< peak memory for each point, in bytes beyond the point itself; 0: not compared with the available memory
  std::function<void(const PointFile&)> check = {};  ///< called after reading; may refuse the points
};

/// Parses the command line, and reads no file. For groups, `source` is the first file. `bytes_a_point` remains 0.
/// Throws WrongUsage that names the value.
ComplexRequest parse_request(const ComplexArguments& arguments, ChosenFor chosen_for = ChosenFor::all_points);

/// A run of a verb that makes a complex, with its points and its radius.
struct ComplexRun : Run {
  /// Reads all points of the file, and chooses the radius if `wanted` has a rule. Prints warnings unless quiet. Sets
  /// `points`, `read_seconds`, `alpha` and `choose_seconds` of `stats`. Throws BadInput, Failure, Cancelled; WrongUsage
  /// if there are fewer plateaus than the rank.
  ComplexRun(const ComplexRequest& wanted, const OutputArguments& arguments);

  /// Writes the report of --stats if requested, and gives all files their names. Throws Failure, ClosedPipe, Cancelled.
  void finish();
  /// Returns the reason why the complex has no triangle, such as "no triangle has circumradius <= 0.5". `distinct` is
  /// the number of distinct points. Requires: the complex has no triangle.
  std::string why_empty(std::size_t distinct) const;
  /// Prints "5 points (1 duplicate), MADE, alpha auto = 0.5 -> TARGETS" unless quiet.
  void summarize(std::size_t duplicates, const std::string& made, const std::string& targets) const;

  ComplexRequest request;
  PointFile file;
  const std::vector<Point>& points() const { return file.points; }
  double alpha = 0;  ///< given, or chosen by a rule; infinity if the points have no triangle
  Stats stats = {};  ///< the verb sets the members that ComplexRun does not set
};

}  // namespace rbpa::app

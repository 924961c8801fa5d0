// What: a run on groups of points, from the command line to a complex for each group.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/polygon/shape_files.h"
#include "plane/named_groups.h"
#include "rbpa/plane/groups.h"
#include "shared/alpha_option.h"
#include "shared/complex_run.h"
#include "shared/run.h"
#include "shared/stats.h"

namespace rbpa::app {

/// The command line, parsed.
struct GroupRequest {
  ComplexRequest complex;
  GroupSources sources;
  std::vector<Target> targets;
};

/// Parses the command line, and reads no file. Throws WrongUsage that names the value; Failure if a target cannot be
/// written there.
/// Requires: arguments.has_groups(), and `targets` are parsed from the arguments.
GroupRequest parse_group_request(const ComplexArguments& arguments, const std::vector<Target>& targets);

struct GroupRun : Run {
  /// Reads the points, makes the complex of each group, and prints warnings unless quiet. Fills in `points`,
  /// `read_seconds` and `build_seconds` of `stats`. Throws BadInput, Failure, Cancelled.
  GroupRun(const GroupRequest& wanted, const ComplexArguments& arguments, GroupShapesOptions shape_options);

  NamedShapes named_shapes() const;
  std::size_t triangles() const { return shapes.triangle_begin.back(); }
  /// Writes the report of --stats if it is requested, gives all files their names, and prints, unless quiet, how many
  /// groups have no polygon. Throws Failure, ClosedPipe, Cancelled.
  void finish();
  /// Prints, unless quiet: "8 points, 3 groups, MADE -> TARGETS".
  void summarize(const std::string& made) const;

  GroupRequest request;
  std::optional<std::string> stats_file;
  NamedGroups named;
  GroupShapes shapes;
  std::vector<std::size_t> sizes;  ///< number of points in each group
  Stats stats = {};                ///< the verb fills in what the members of GroupRun do not
};

}  // namespace rbpa::app

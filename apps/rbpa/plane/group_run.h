// What: runs a verb on groups of points, from the command line to a complex for each group.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/polygon/write_shapes.h"
#include "plane/named_groups.h"
#include "rbpa/plane/groups.h"
#include "shared/alpha_option.h"
#include "shared/complex_run.h"
#include "shared/run.h"
#include "shared/stats.h"

namespace rbpa::app {

/// The parsed command line.
struct GroupRequest {
  ComplexRequest complex;
  GroupSources sources;
  std::vector<Target> targets;
};

/// Parses the command line, and reads no file. Throws WrongUsage that names the value; Failure if a target cannot be
/// written.
/// Requires: arguments.has_groups(); `targets` are parsed from `arguments`.
GroupRequest parse_group_request(const ComplexArguments& arguments, const std::vector<Target>& targets);

struct GroupRun : Run {
  /// Reads the points, makes the complex of each group, and prints warnings unless quiet. Sets `points`, `read_seconds`
  /// and `build_seconds` of `stats`. Throws BadInput, Failure, Cancelled.
  GroupRun(const GroupRequest& wanted, const ComplexArguments& arguments, GroupShapesOptions shape_options);

  NamedShapes named_shapes() const;
  std::size_t triangles() const { return shapes.triangle_begin.back(); }
  /// Writes the report of --stats if requested, gives all files their names, and prints, unless quiet, the number of
  /// groups without a polygon. Throws Failure, ClosedPipe, Cancelled.
  void finish();
  /// Prints "8 points, 3 groups, MADE -> TARGETS" unless quiet.
  void summarize(const std::string& made) const;

  GroupRequest request;
  NamedGroups named;
  GroupShapes shapes;
  std::vector<std::size_t> sizes;  ///< number of points in each group
  Stats stats = {};                ///< the verb sets the members that GroupRun does not set
};

}  // namespace rbpa::app

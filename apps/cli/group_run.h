// What: a run on groups of points, each by itself: from the command line to the complex of every group.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/alpha_choice.h"
#include "cli/complex_run.h"
#include "cli/named_groups.h"
#include "cli/run.h"
#include "cli/stats.h"
#include "io/polygon/shape_files.h"
#include "rbpa/groups.h"

namespace rbpa::app {

/// What the command line means.
struct GroupRequest {
  ComplexRequest complex;
  GroupSources sources;
  std::vector<Target> targets;
};

/// Throws WrongUsage naming the value, before anything is read. Requires: ask_for_groups(), and targets parsed of the arguments.
GroupRequest parse_group_request(const ComplexArguments& arguments, const std::vector<Target>& targets);

struct GroupRun : Run {
  /// Reads the points and makes the complexes of all groups. Throws BadInput, Failure, Cancelled.
  GroupRun(const GroupRequest& wanted, const ComplexArguments& arguments, GroupShapesOptions shape_options);

  NamedShapes named_shapes() const;
  std::size_t triangles() const { return shapes.triangle_begin.back(); }
  /// Writes the report, if there is to be one, gives all files their names, and says which groups have no polygon. Throws
  /// Failure, Cancelled.
  void finish();
  /// Says, unless quiet: "8 points, 3 groups, MADE -> TARGETS".
  void summarize(const std::string& made) const;

  GroupRequest request;
  std::optional<std::string> stats_file;
  NamedGroups named;
  GroupShapes shapes;
  std::vector<std::size_t> sizes;  ///< points in each group
  Stats stats = {};                ///< what is known so far
};

}  // namespace rbpa::app

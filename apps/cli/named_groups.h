// What: points in groups that have names: of one file or several, by a column, a property of Features, or the file.
// Law:  groups depend on names and points alone: names that are numbers are in their order, others in that of their bytes, and
//       files in that of the command line.
// Cost: a look-up for each point.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/point_arguments.h"
#include "cli/run.h"
#include "io/point_file.h"
#include "rbpa/groups.h"

namespace rbpa::app {

struct GroupSources {
  std::vector<PointSource> files;
  bool by_file = false;
  std::optional<std::string> radius = std::nullopt;  ///< a column
};

/// Requires: `groups` ask for groups. Throws WrongUsage naming the value.
GroupSources parse_group_sources(const PointArguments& arguments, const GroupArguments& groups,
                                 const std::optional<std::string>& radius = std::nullopt);

/// Throws as require_different(), for each of the files.
void require_different(const std::vector<std::string>& outputs, const GroupSources& sources);

struct NamedGroups {
  PointFile file = {};  ///< the points of all files, one after the other
  std::vector<std::string> names = {};
  bool are_numbers = false;  ///< all names are, and JSON reads them as different ones
  Groups groups = {};
  /// With a column of radii: that of each group, NaN where there is no one; and of these groups why, else "".
  std::vector<double> radii = {};
  std::vector<std::string> radius_problems = {};
};

/// Reads all files, and says how many points are in no group. Throws BadInput, Failure, Cancelled.
NamedGroups read_groups(const Run& run, const GroupSources& sources);

}  // namespace rbpa::app

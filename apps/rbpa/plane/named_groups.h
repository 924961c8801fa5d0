// What: reads points in named groups: from one file or several, by a column, by a property of Features, or by file.
// Law:  groups depend on names and points alone. Groups named by numbers are in numerical order, others in the order of
//       their bytes, files in the order of the command line.
// Cost: one look-up for each point.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/point_file.h"
#include "rbpa/plane/groups.h"
#include "shared/point_arguments.h"
#include "shared/run.h"

namespace rbpa::app {

struct GroupSources {
  std::vector<PointSource> files;
  bool by_file = false;
  std::optional<std::string> radius = std::nullopt;  ///< the column with the radius of each group
};

/// Parses where points and their groups are read from. Requires: groups.ask_for_groups(). Throws WrongUsage that names
/// the value.
GroupSources parse_group_sources(const PointArguments& arguments, const GroupArguments& groups,
                                 const std::optional<std::string>& radius = std::nullopt);

/// Calls require_different() for each of the files.
void require_different(const std::vector<std::string>& outputs, const GroupSources& sources);

struct NamedGroups {
  PointFile file = {};  ///< the points of all files, one after the other
  std::vector<std::string> names = {};
  bool are_numbers = false;  ///< all names are numbers of JSON with different values
  Groups groups = {};
  /// Filled in only with a column of radii: the radius of each group, NaN if it has none; why it has none, else "".
  std::vector<double> radii = {};
  std::vector<std::string> radius_problems = {};
};

/// Reads all files, and prints how many points are in no group. Throws BadInput, Failure, Cancelled.
NamedGroups read_groups(const Run& run, const GroupSources& sources);

}  // namespace rbpa::app

// What: reads points in named groups, from one file or several. A column, a property of Features or the file names the
//       group.
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
  std::optional<std::string> radius = std::nullopt;  ///< name of the column with the radius of each group
};

/// Parses from where points and their groups are read. Requires: groups.has_groups(). Throws WrongUsage that names
/// the value.
GroupSources parse_group_sources(const PointArguments& arguments, const GroupArguments& groups,
                                 const std::optional<std::string>& radius = std::nullopt);

/// Throws, by require_different(), if one of `outputs` is a file of `sources`.
void require_different(const std::vector<std::string>& outputs, const GroupSources& sources);

struct NamedGroups {
  PointFile file = {};  ///< the points of one file after another
  std::vector<std::string> names = {};
  bool are_numbers = false;  ///< all names are numbers of JSON, with different values below 2^53
  Groups groups = {};
  /// For each group its radius, NaN if it has none; and the reason why it has none, else "". Empty without a column of
  /// radii.
  std::vector<double> radii = {};
  std::vector<std::string> radius_problems = {};
};

/// Reads all files, and prints warnings and the number of points in no group, unless quiet. Throws BadInput, also if
/// coordinate systems differ; Failure, Cancelled.
NamedGroups read_groups(const Run& run, const GroupSources& sources);

}  // namespace rbpa::app

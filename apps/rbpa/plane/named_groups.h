// What: reads points in named groups from one or several files. A column, a property of Features or the file gives the
//       name of the group of a point.
// Law:  groups depend on names and points alone. Groups are in numerical order if all names are numbers, otherwise in
//       the order of the bytes of their names; groups named by files are in the order of the command line. Groups by
//       several columns are in the order of the first column, then of the second, and so on.
// Cost: one look-up for each point.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/point_file.h"
#include "io/polygon/attributes.h"
#include "rbpa/plane/groups.h"
#include "shared/point_arguments.h"
#include "shared/run.h"

namespace rbpa::app {

struct GroupSources {
  std::vector<PointSource> files;
  bool by_file = false;
  std::optional<std::string> radius = std::nullopt;  ///< name of the column with the radius of each group
};

/// Parses the files and columns from which points and their groups are read. Requires: groups.has_groups(). Throws
/// WrongUsage that names the value.
GroupSources parse_group_sources(const PointArguments& arguments, const GroupArguments& groups,
                                 const std::optional<std::string>& radius = std::nullopt);

/// Throws as require_different() for paths does if one of `outputs` is a file of `sources`.
void require_different(const std::vector<std::string>& outputs, const GroupSources& sources);

struct NamedGroups {
  PointFile file = {};                  ///< the points of all files, one file after another
  std::vector<std::string> names = {};  ///< by several columns: their values as a line of CSV
  bool are_numbers = false;  ///< whether all names are numbers of JSON, with different values of magnitude below 2^53
  Groups groups = {};
  std::vector<PointColumn> keys = {};  ///< the columns, if there are several, with a value for each group
  /// The radius of each group, or NaN; and for NaN the reason, otherwise "". Both are empty without a column of radii.
  std::vector<double> radii = {};
  std::vector<std::string> radius_problems = {};
};

/// Returns the groups of points that were read from `sources`, in the order of the sources.
NamedGroups groups_in(const GroupSources& sources, std::vector<PointFile> files);

/// Returns the keys as attributes of features, whose names are not those of other properties of groups or in `taken`.
std::vector<Attribute> key_attributes(const NamedGroups& named, std::vector<std::string> taken = {});

/// Returns a warning about `left_out` points without a group; none if it is 0.
std::vector<std::string> warnings_on(std::size_t left_out);

/// Reads all files. Prints warnings and the number of points without a group, unless quiet. Throws BadInput, also if
/// coordinate systems differ; Failure, Cancelled.
NamedGroups read_groups(const Run& run, const GroupSources& sources);

}  // namespace rbpa::app

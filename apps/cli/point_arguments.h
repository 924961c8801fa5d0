// What: the options about points: where they are, in which format, and what of it counts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/formats.h"

namespace rbpa::app {

/// What the command line says of the pixels of an image that are points, as text.
struct PixelArguments {
  std::optional<std::string> foreground;
  std::optional<std::string> threshold;
};

/// What the command line says, as text.
struct PointArguments {
  std::string points;  ///< the file
  std::optional<std::string> format;
  std::optional<std::string> columns;
  PixelArguments pixels;
  std::optional<std::string> where;
  std::optional<std::string> crs;
  std::optional<std::string> layer;
  bool skip_invalid = false;
  bool vertices = false;
  bool shift_longitude = false;
};

/// The same of points in space.
struct SpacePointArguments {
  std::string points;  ///< the file
  std::optional<std::string> format;
  std::optional<std::string> columns;
  std::optional<std::string> where;
  bool skip_invalid = false;
  bool waters = false;
};

/// What the command line says of groups of points, as text.
struct GroupArguments {
  std::vector<std::string> inputs;      ///< all files; the first is PointArguments::points as well
  std::optional<std::string> group_by;  ///< a column
  bool group_by_file = false;

  /// Throws WrongUsage for several files whose points are in no groups.
  bool ask_for_groups() const;
};

/// Where the points come from: the format as said, else by the ending; standard input is text. Throws WrongUsage naming
/// the value, or an option that is about another format.
PointSource parse_source(const PointArguments& arguments, const GroupColumns& columns = {});

/// Where points in space come from.
struct SpacePointSource {
  std::string path;
  Format format;
  CloudRequest choice = {};
};

/// Likewise for points in space; with the columns that `option` requires, if any, and those wanted where present.
SpacePointSource parse_space_source(const SpacePointArguments& arguments, std::vector<WantedColumn> columns = {},
                                    const std::string& option = "");

/// The columns that name a point: those of atoms, also in tables that have them.
std::vector<WantedColumn> columns_of_names();

/// Throws WrongUsage unless an option that was given fits the format: "--where: found a format FOUND, expected EXPECTED".
void require_format(bool fits, const std::string& option, const std::string& found, const std::string& expected);

}  // namespace rbpa::app

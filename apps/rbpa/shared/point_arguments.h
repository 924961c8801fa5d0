// What: parses the options about points: the file and format from which points are read, and the choice of points.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/cloud/ball_radii.h"
#include "io/cloud/read_points.h"
#include "io/cloud/read_space_points.h"
#include "io/formats.h"

namespace rbpa::app {

/// The options about points in space, as text.
struct SpacePointArguments {
  std::string points;  ///< path of the file; "-" means standard input
  std::optional<std::string> format, columns, where, bounds, resolution;
  bool skip_invalid = false, waters = false;
};

/// The options about points of the plane, as text. Some verbs also read points in space by them.
struct PointArguments : SpacePointArguments {
  std::optional<std::string> foreground, threshold;  ///< of an image: which pixels are points
  std::optional<std::string> crs, layer;
  bool vertices = false, shift_longitude = false;
  bool columns_may_have_z = false;  ///< the verb uses heights, and takes their column from --columns
};

/// The reason why an option is refused when groups are requested.
inline constexpr const char* not_with_groups = "cannot be combined with --group-by or --group-by-file";

/// The options about groups of points, as text.
struct GroupArguments {
  std::vector<std::string> inputs;      ///< paths of all files; the first is also PointArguments::points
  std::optional<std::string> group_by;  ///< names of the columns with the names of groups, with commas between them
  bool group_by_file = false;

  /// Returns whether groups are requested. Throws WrongUsage for several files without --group-by or --group-by-file,
  /// and if both options are given.
  bool has_groups() const;
};

/// The options about the radii of balls, as text.
struct BallRadiiArguments {
  std::optional<std::string> radii, radius_default;
};

/// Parses the options, and reads the file of --radii. Throws as parse_real() and BallRadii do.
BallRadii parse_ball_radii(const BallRadiiArguments& arguments);

/// Parses the file, format and choice of points, with `columns` for groups; the format as parse_format() does. Throws
/// WrongUsage that names the value, or an option that belongs to another format.
PointSource parse_source(const PointArguments& arguments, const GroupColumns& columns = {});

/// A file of points in space, and the choice of data that are read from the file.
struct SpacePointSource {
  std::string path;
  Format format;
  CloudRequest choice = {};
};

/// Parses the file, format and choice of points in space, as parse_source() does for the plane. `columns` are read as
/// well; `option`, for messages, is the option that requires `columns`.
SpacePointSource parse_space_source(const SpacePointArguments& arguments, std::vector<WantedColumn> columns = {},
                                    const std::string& option = "");

/// Throws WrongUsage that names `option` unless the points of `format` are atoms. `found` describes other formats in
/// the message, such as "without atoms".
void require_molecule(Format format, const std::string& option, const std::string& found);

/// Parses --box. The cell has no edges for "auto", the cell of a file of `format`. Throws WrongUsage that names the
/// text, or a format without cells.
UnitCell parse_box(const std::string& text, Format format);

/// Returns the columns that name an atom, each of them optional. Tables of text may have these columns too.
std::vector<WantedColumn> columns_of_names();

}  // namespace rbpa::app

// What: reads points in the plane from a file of any supported format.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/cloud/cloud.h"
#include "io/cloud/images.h"
#include "io/formats.h"
#include "io/point_file.h"
#include "io/text/columns.h"
#include "io/text/condition.h"

namespace rbpa::app {

struct PointSource {
  std::string path = {};  ///< "-" is standard input
  Format format = Format::text;
  /// Columns of a table; absent: those that the header names, or the first two.
  std::optional<std::vector<Column>> columns = std::nullopt;
  PixelRule pixels = {};                          ///< for images
  bool heights = false;                           ///< fill PointFile::z
  bool skip_invalid = false;                      ///< leave out lines of text, and records of LAS, that are not points
  bool vertices = false;                          ///< take the vertices of lines and polygons as points
  std::optional<Condition> where = std::nullopt;  ///< selects points, in formats with fields
  GroupColumns properties = {};                   ///< GeoJSON: properties of Features that group points
  std::optional<Crs> crs = std::nullopt;          ///< of the points; overrides the file's
  std::optional<std::string> layer = std::nullopt;  ///< of a source of OGR that has several layers
  bool shift_longitude = false;                     ///< add 360 to longitudes below 0
};

/// Reads the points in the order of the file, all finite. A gzip file is decompressed. Throws BadInput with the file,
/// the line or the point, what was found and what was expected; Failure; Cancelled.
PointFile read_points(const PointSource& source);

/// Checks options after the content of standard input has shown its format. Throws WrongUsage if an option asks for
/// data that the format does not have.
void require_readable(Format format, bool columns, bool skip_invalid, bool vertices,
                      const std::optional<Condition>& where);

/// Sets the system of the points: the command line, `said`, overrides the file, and a difference gives a warning.
void settle_crs(PointFile& file, const std::optional<Crs>& said);

/// Reads points from the content of a file; `name` stands for it in messages, and the path of `source` is ignored.
/// Throws as read_points().
PointFile points_in(std::string_view bytes, const std::string& name, const PointSource& source);

/// Opens content in a format that cloud_format() knows. Throws as read_points(), and BadInput if the content is empty.
std::unique_ptr<Cloud> open_plane_cloud(Content content, const PointSource& source);

/// Reads all points, and the warnings about them.
PointFile read_plane_points(Cloud& cloud);

/// Appends the points of a block.
void append_points(const CloudBlock& block, std::vector<Point>& points);

}  // namespace rbpa::app

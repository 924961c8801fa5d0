// What: points of the plane from a file of any format we read.
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
  std::optional<std::vector<Column>> columns =
      std::nullopt;                                 ///< of text; absent: as its header says, else the first two
  PixelRule pixels = {};                            ///< of images
  bool heights = false;                             ///< PointFile::z
  bool skip_invalid = false;                        ///< leave out lines of text, and records of LAS, that are no point
  bool vertices = false;                            ///< take those of lines and polygons as points
  std::optional<Condition> where = std::nullopt;    ///< of formats with fields: which points count
  GroupColumns properties = {};                     ///< of GeoJSON: what of its Features points in groups have
  std::optional<Crs> crs = std::nullopt;            ///< of the points, whatever the file says
  std::optional<std::string> layer = std::nullopt;  ///< of a source of OGR that has several
  bool shift_longitude = false;                     ///< add 360 to longitudes below 0
};

/// Whether a file that begins as a gzip file does is one: numbers may begin like it.
bool may_be_packed(const PointSource& source);

/// The points in the order of the file, all finite. A gzip file is read as what was compressed. Throws BadInput naming
/// the file, the line or the point, what was found and what was expected; Failure; Cancelled.
PointFile read_points(const PointSource& source);

/// Of standard input whose content has shown its format. Throws WrongUsage where an option asks for what it does not
/// have.
void require_readable(Format format, bool columns, bool skip_invalid, bool vertices,
                      const std::optional<Condition>& where);

/// What the command line says of the system of the points counts more than what the file says.
void settle_crs(PointFile& file, const std::optional<Crs>& said);

/// The same of the content of a file, which messages call `name`: the path does not count.
PointFile points_in(std::string_view bytes, const std::string& name, const PointSource& source);

/// Of a format that cloud_format() knows. Throws as read_points(); where there are no bytes at all as well.
std::unique_ptr<Cloud> open_plane_cloud(Content content, const PointSource& source);

/// All its points and what there is to remark on them.
PointFile read_plane_points(Cloud& cloud);

/// Appends those of a block.
void append_points(const CloudBlock& block, std::vector<Point>& points);

}  // namespace rbpa::app

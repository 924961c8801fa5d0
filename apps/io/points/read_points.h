// What: points from a file of any format we read.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/condition.h"
#include "io/formats.h"
#include "io/point_file.h"
#include "io/points/foreground.h"
#include "io/table/columns.h"

namespace rbpa::app {

struct PointSource {
  std::string path;  ///< "-" is standard input
  PointFormat format = PointFormat::text;
  std::optional<Columns> columns = std::nullopt;    ///< of text; absent: as its header says, else the first two
  PixelRule pixels = {};                            ///< of images
  bool skip_invalid = false;                        ///< leave out lines of text, and records of LAS, that are no point
  bool vertices = false;                            ///< take those of lines and polygons as points
  std::optional<Condition> where = std::nullopt;    ///< of LAS and text: which points count
  std::optional<Crs> crs = std::nullopt;            ///< of the points, whatever the file says
  std::optional<std::string> layer = std::nullopt;  ///< of a source of OGR that has several
  bool shift_longitude = false;                     ///< add 360 to longitudes below 0
};

/// What PointSource::where may name; nothing where points have no fields beside them.
std::optional<FieldNames> fields_of(PointFormat format);

/// The points in the order of the file, all finite. A gzip file is read as what was compressed. Throws BadInput naming
/// the file, the line or the point, what was found and what was expected; Failure; Cancelled.
PointFile read_points(const PointSource& source);

/// What the command line says of the system of the points counts more than what the file says.
void settle_crs(PointFile& file, const std::optional<Crs>& said);

/// The same of the content of a file, which messages call `name`: the path does not count.
PointFile points_in(std::string_view bytes, const std::string& name, const PointSource& source);

}  // namespace rbpa::app

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
  /// Columns of a table: as CloudRequest::columns in the plane.
  std::optional<std::vector<Column>> columns = std::nullopt;
  PixelRule pixels = {};                            ///< for images
  bool heights = false;                             ///< fill PointFile::z
  bool skip_invalid = false;                        ///< as CloudRequest::skip_invalid
  bool vertices = false;                            ///< take the vertices of lines and polygons as points
  bool beside_points = false;                       ///< lines; no warning about degrees: points have caused it, if any
  std::optional<Condition> where = std::nullopt;    ///< selects points, in formats with fields
  std::optional<Crs> crs = std::nullopt;            ///< coordinate system of the points; overrides that of the file
  std::optional<std::string> layer = std::nullopt;  ///< name of the layer, if a source of OGR has several
  bool shift_longitude = false;                     ///< add 360 to longitudes below 0
  std::optional<FieldChoice> keeps = std::nullopt;  ///< as CloudRequest::keeps
  PointWindow window = {};                          ///< as CloudRequest::window
  bool scan_counts = false;                         ///< as CloudRequest::scan_counts
  unsigned threads = 0;                             ///< as CloudRequest::threads
};

/// Reads the points in the order of the file, all finite. A gzip file is decompressed. Throws BadInput that names the
/// file, the line or the point, what was found and what was expected; WrongUsage if the content does not fit an option,
/// or two columns are the same; Failure; Cancelled.
PointFile read_points(const PointSource& source);

/// The names of options that request data that not every format has; null for an option that is not given.
struct OptionNames {
  const char* columns = nullptr;
  const char* skip_invalid = nullptr;
  const char* vertices = nullptr;
  const char* fields = nullptr;  ///< --where, or another option that reads fields
};

/// Throws WrongUsage if points of `format` lack data that an option requests. `found` begins the text after "found".
void require_readable(Use use, Format format, const OptionNames& options, const std::string& found = "a format");

/// Throws WrongUsage like require_readable() for standard input, whose content shows `format` only after options are
/// parsed; also for a field that the format does not have, and for a text that is compared with a field of numbers.
void require_readable_input(Use use, Format format, bool columns, bool skip_invalid, bool vertices,
                            const std::optional<Condition>& where);

/// Sets file.crs to `said`, the value of --crs, if it is present, with a warning if the file names another system. Sets
/// file.degrees if the system is geographic.
void settle_crs(PointFile& file, const std::optional<Crs>& said);

/// Returns the warning that all of several points are `p`.
std::string warning_on_equal(std::size_t points, const Point& p);

/// Reads points from `bytes`, the content of a file; messages call the file `name`, and source.path is ignored. Throws
/// as read_points().
PointFile points_in(std::string_view bytes, const std::string& name, const PointSource& source);

/// Returns whether the file may be a COPC file of which only a part is needed; such a file is not read into memory.
bool reads_parts(const std::string& path, Format format, const PointWindow& window);

/// Opens content. Requires: source.format has a cloud_format(). Throws as read_points(), and BadInput if the content is
/// empty.
std::unique_ptr<Cloud> open_plane_cloud(Content content, const PointSource& source);

/// Reads all points, and calls cloud.finish(). Throws as Cloud::next().
PointFile read_plane_points(Cloud& cloud);

/// Appends the points of `block` to `points`.
void append_points(const CloudBlock& block, std::vector<Point>& points);

}  // namespace rbpa::app

// What: writes files of heights, or of other values: rasters of cells, and contour lines.
// Law:  the bytes are a function of the arguments alone. Numbers read back to the same doubles.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/crs.h"
#include "io/formats.h"
#include "rbpa/plane/contours.h"
#include "rbpa/plane/interpolate_grid.h"

namespace rbpa::app {

/// Writes a raster, cell by cell: an ESRI ASCII grid, or a NumPy array of doubles with a row for each row of cells, the
/// top row first. A cell without a value has the NODATA_value of the grid, -9999 or, if values may be that low, -1e300;
/// in the array it is NaN.
class RasterWriter {
 public:
  /// Writes the header. `least` is the least value. Requires: `format` is esri_grid or npy. Keeps a reference to
  /// `file`; all members throw as OutputFile::write().
  RasterWriter(OutputFile& file, Format format, const Raster& raster, double least);
  /// Writes the next cells, as TakeCells receives them.
  void write(std::span<const double> values);

 private:
  OutputFile& file_;
  bool is_text_;
  std::size_t columns_, column_ = 0;
  double nodata_;
};

/// Writes contour lines: GeoJSON with a Feature for each line, a LineString with the properties "height" and "closed";
/// or well-known text, one MULTILINESTRING Z whose z is the height. A closed line ends with its first point. Requires:
/// `format` is geojson or wkt. Throws Cancelled, and as OutputFile::write().
void write_contours(OutputFile& file, Format format, const Contours& lines, std::span<const double> levels,
                    const std::optional<Crs>& crs);

}  // namespace rbpa::app

#include "io/polygon/write_heights.h"

#include <cmath>
#include <limits>
#include <string>

#include "io/bytes/npy.h"
#include "io/interrupt.h"
#include "io/polygon/write_shapes.h"

namespace rbpa::app {

RasterWriter::RasterWriter(OutputFile& file, Format format, const Raster& raster, double least)
    : file_(file),
      is_text_(format == Format::esri_grid),
      columns_(raster.columns),
      nodata_(!is_text_       ? std::numeric_limits<double>::quiet_NaN()
              : least > -9999 ? -9999
                              : -1e300) {
  if (!is_text_)
    file.write(npy_header("<f8", raster.rows, ", " + std::to_string(raster.columns)));
  else
    file.write_all("ncols ", raster.columns, "\nnrows ", raster.rows, "\nxllcorner ", raster.origin.x, "\nyllcorner ",
                   raster.origin.y, "\ncellsize ", raster.cell, "\nNODATA_value ", nodata_, "\n");
}

void RasterWriter::write(std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    const double value = std::isnan(values[i]) ? nodata_ : values[i];
    if (!is_text_) {
      file_.write_binary(value);
      continue;
    }
    file_.write_number(value);
    column_ = column_ + 1 < columns_ ? column_ + 1 : 0;
    file_.write(column_ == 0 ? "\n" : " ");
  }
}

void write_contours(OutputFile& file, Format format, const Contours& lines, std::span<const double> levels,
                    const std::optional<Crs>& crs) {
  const bool is_json = format == Format::geojson;
  file.write(is_json ? geojson_collection(crs) : lines.empty() ? "MULTILINESTRING Z EMPTY" : "MULTILINESTRING Z (");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Contour& line = lines[i];
    const double height = levels[line.level];
    if (i > 0) file.write(",");
    if (is_json)
      file.write_all("\n{\"type\":\"Feature\",\"properties\":{\"height\":", height,
                     ",\"closed\":", line.is_closed ? "true" : "false",
                     "},\"geometry\":{\"type\":\"LineString\",\"coordinates\":[");
    else
      file.write("(");
    const std::size_t n = line.points.size();
    for (std::size_t k = 0; k < n + (line.is_closed ? 1 : 0); ++k) {
      if (k % 16384 == 0) stop_if_interrupted();
      const Point& p = line.points[k % n];
      if (k > 0) file.write(",");
      is_json ? file.write_all("[", p.x, ",", p.y, "]") : file.write_all(p.x, " ", p.y, " ", height);
    }
    file.write(is_json ? "]}}" : ")");
  }
  file.write(is_json ? "\n]}\n" : lines.empty() ? "\n" : ")\n");
}

}  // namespace rbpa::app

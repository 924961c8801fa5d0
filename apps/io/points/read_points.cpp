#include "io/points/read_points.h"

#include <utility>

#include "io/failure.h"
#include "io/gis/geojson_points.h"
#include "io/gis/wkt_points.h"
#include "io/gunzip.h"
#include "io/input_bytes.h"
#include "io/las/las_header.h"
#include "io/las/las_points.h"
#include "io/las/selection.h"
#include "io/off_header.h"
#include "io/ogr/ogr.h"
#include "io/ply_data.h"
#include "io/points/binary_points.h"
#include "io/points/longitude.h"
#include "io/points/npy_points.h"
#include "io/points/off_points.h"
#include "io/points/pgm_points.h"
#include "io/points/ply_points.h"
#include "io/points/png_points.h"
#include "io/table/text_points.h"

namespace rbpa::app {
namespace {

PointFile parse(std::string_view bytes, const std::string& name, const PointSource& source) {
  switch (source.format) {
    case PointFormat::npy:
      return read_npy_points(bytes, name);
    case PointFormat::off:
      return read_off_points(bytes, name);
    case PointFormat::ply:
      return read_ply_points(bytes, name);
    case PointFormat::raw:
      return {.points = read_raw_points(bytes, name)};
    case PointFormat::png:
      return {.points = read_png_points(bytes, name, source.pixels)};
    case PointFormat::pgm:
      return {.points = read_pgm_points(bytes, name, source.pixels)};
    case PointFormat::las:
      return read_las_points(bytes, name, source.where, source.skip_invalid);
    case PointFormat::geojson:
      return read_geojson_points(bytes, name, source.vertices);
    case PointFormat::wkt:
      return read_wkt_points(bytes, name, source.vertices);
    case PointFormat::ogr:  // which is no bytes
    case PointFormat::text:
      break;
  }
  return read_text_points(bytes, name,
                          {.columns = source.columns,
                           .skip_invalid = source.skip_invalid,
                           .vertices = source.vertices,
                           .where = source.where});
}

Claim claim_of(const PointSource& source) {
  switch (source.format) {
    case PointFormat::npy:
      return {claimed_npy_size};
    case PointFormat::off:
      return {claimed_off_size};
    case PointFormat::ply:
      return {claimed_ply_size};
    case PointFormat::pgm:
      return {claimed_pgm_size};
    case PointFormat::las:
      return las_claim(source.skip_invalid);
    default:
      return {};
  }
}

PointFile settled(PointFile file, const std::string& name, const PointSource& source) {
  settle_crs(file, source.crs);
  if (source.shift_longitude) shift_longitude(file, name);
  if (file.degrees) remark_on_degrees(file);
  return file;
}

}  // namespace

std::optional<FieldNames> fields_of(PointFormat format) {
  if (format == PointFormat::text) return names_of_columns();
  if (format == PointFormat::las) return names_of_las_fields();
  return std::nullopt;
}

void settle_crs(PointFile& file, const std::optional<Crs>& said) {
  if (said && file.crs && file.crs->text() != said->text())
    file.remarks.push_back("the file says " + file.crs->text() + ", and --crs " + said->text() + " is taken");
  if (said) file.crs = said;
  if (file.crs && file.crs->degrees) file.degrees = true;
}

PointFile read_points(const PointSource& source) {
  if (source.format == PointFormat::ogr)
    return settled(read_ogr_points(source.path, source.layer, source.vertices), source.path, source);
  InputBytes input(source.path, "a file of points");
  // Numbers may begin like a gzip file.
  if (is_gzip(input.bytes()) && (source.format != PointFormat::raw || is_gzip_name(source.path)))
    input.gunzip(claim_of(source), " (rbpa stream reads tables, .npy, .f64xy and LAS a block at a time)");
  return points_in(input.bytes(), input.name(), source);
}

PointFile points_in(std::string_view bytes, const std::string& name, const PointSource& source) {
  // No points may be meant; no bytes at all come from a command that failed before.
  if (bytes.empty()) bad_input(name, "an empty file", "points");
  return settled(parse(bytes, name, source), name, source);
}

}  // namespace rbpa::app

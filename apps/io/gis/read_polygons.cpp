#include "io/gis/read_polygons.h"

#include "io/failure.h"
#include "io/gis/geojson_points.h"
#include "io/gis/poly_polygons.h"
#include "io/gis/wkt_points.h"
#include "io/gunzip.h"
#include "io/input_bytes.h"

namespace rbpa::app {
namespace {

PolygonFile parse(std::string_view bytes, const std::string& name, PolygonFormat format) {
  switch (format) {
    case PolygonFormat::geojson:
      return read_geojson_polygons(bytes, name);
    case PolygonFormat::wkt:
      return read_wkt_polygons(bytes, name);
    case PolygonFormat::poly:
      break;
  }
  return read_poly_polygons(bytes, name);
}

}  // namespace

PolygonFile read_polygons(const std::string& path, PolygonFormat format) {
  InputBytes input(path, "a file of polygons");
  if (is_gzip(input.bytes())) input.gunzip({});
  if (input.bytes().empty()) bad_input(input.name(), "an empty file", "polygons");
  return parse(input.bytes(), input.name(), format);
}

}  // namespace rbpa::app

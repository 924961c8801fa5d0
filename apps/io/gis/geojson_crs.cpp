#include "io/gis/geojson_crs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rbpa::app {

std::string crs_member(const std::optional<Crs>& crs) {
  if (!crs || crs->is_wgs84()) return "";
  return "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"" + crs->urn() + "\"}},";
}

std::optional<std::string> geojson_caution(const Shape& shape) {
  if (shape.crs && !shape.crs->is_wgs84())
    return "written in " + shape.crs->text() +
           ", as its crs member says; readers that go by RFC 7946 take it for degrees of WGS 84 (ogr2ogr -t_srs "
           "EPSG:4326 "
           "makes them)";
  double x = 0, y = 0;
  for (const Point& p : shape.points) {
    x = std::max(x, std::abs(p.x));
    y = std::max(y, std::abs(p.y));
  }
  const double max_x = shape.degrees || shape.crs ? 360 : 180;  // longitudes may be shifted
  if (x <= max_x && y <= 90) return std::nullopt;
  char size[64];
  std::snprintf(size, sizeof size, "%.6g and %.6g", x, y);
  return "coordinates go up to " + std::string(size) +
         ", and GeoJSON means degrees of WGS 84 (--crs EPSG:... says what they are)";
}

}  // namespace rbpa::app

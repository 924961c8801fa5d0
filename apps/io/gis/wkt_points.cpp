#include "io/gis/wkt_points.h"

#include "io/failure.h"
#include "io/gis/wkt_geometry.h"
#include "io/interrupt.h"
#include "io/lines.h"

namespace rbpa::app {

namespace {

PointFile read_all(WktGeometries& geometries, std::string_view text, const std::string& name) {
  PointFile file;
  try {
    for (std::size_t i = 0; geometries.next(file.points); ++i)
      if (i % 16384 == 0) stop_if_interrupted();
  } catch (const WktFault& fault) {
    const std::size_t before = count_line_ends(text.substr(0, static_cast<std::size_t>(fault.at - text.data())));
    bad_input(at_line(name, before + 1), fault.found, fault.expected);
  }
  file.crs = geometries.crs();
  file.heights = geometries.heights();
  return file;
}

}  // namespace

PointFile read_wkt_points(std::string_view text, const std::string& name, bool vertices) {
  WktGeometries geometries(text, vertices);
  return read_all(geometries, text, name);
}

PolygonFile read_wkt_polygons(std::string_view text, const std::string& name) {
  PolygonFile file;
  WktGeometries geometries(text, file);
  file.vertices = read_all(geometries, text, name);
  return file;
}

}  // namespace rbpa::app

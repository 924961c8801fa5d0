#include "io/gis/write_polygons.h"

#include "io/gis/polygon_writers.h"

namespace rbpa::app {
namespace {

/// `points`: how many are in each polygon; empty where that does not matter.
void write_all(PolygonSink& sink, const Shape& shape, const std::vector<std::size_t>& points) {
  std::vector<Point> corners;
  const auto write = [&](const Ring& ring) {
    corners.clear();
    for (const std::uint32_t i : ring.points) corners.push_back(shape.points[i]);
    sink.ring(corners);
  };
  for (std::size_t i = 0; i < shape.polygons.size(); ++i) {
    const Polygon& polygon = shape.polygons[i];
    sink.begin({polygon.area, polygon.perimeter, polygon.holes.size(), points.empty() ? 0 : points[i]});
    write(polygon.shell);
    for (const Ring& hole : polygon.holes) write(hole);
    sink.end();
  }
  sink.finish();
}

}  // namespace

void write_geojson(OutputFile& file, const Shape& shape) {
  GeojsonWriter writer(file, shape.crs);
  write_all(writer, shape, points_in_polygons(shape));
}

void write_wkt(OutputFile& file, const Shape& shape) {
  WktWriter writer(file);
  write_all(writer, shape, {});
}

}  // namespace rbpa::app

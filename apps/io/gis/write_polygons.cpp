#include "io/gis/write_polygons.h"

#include "io/gis/polygon_writers.h"

namespace rbpa::app {
namespace {

PolygonOutline outline_of(const Polygon& polygon, const Shape& shape) {
  PolygonOutline outline{.area = polygon.area, .perimeter = polygon.perimeter};
  const auto add = [&](const Ring& ring) {
    std::vector<Point>& points = outline.rings.emplace_back();
    for (const std::uint32_t i : ring.points) points.push_back(shape.points[i]);
  };
  add(polygon.shell);
  for (const Ring& hole : polygon.holes) add(hole);
  return outline;
}

}  // namespace

void write_geojson(OutputFile& file, const Shape& shape) {
  const std::vector<std::size_t> points = points_in_polygons(shape);
  GeojsonWriter writer(file, shape.crs);
  for (std::size_t i = 0; i < shape.polygons.size(); ++i) {
    PolygonOutline outline = outline_of(shape.polygons[i], shape);
    outline.points = points[i];
    writer.add(outline);
  }
  writer.finish();
}

void write_wkt(OutputFile& file, const Shape& shape) {
  WktWriter writer(file);
  for (const Polygon& polygon : shape.polygons) writer.add(outline_of(polygon, shape));
  writer.finish();
}

}  // namespace rbpa::app

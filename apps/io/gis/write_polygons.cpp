#include "io/gis/write_polygons.h"

#include <cmath>
#include <cstdint>
#include <string_view>

#include "io/gis/geojson_crs.h"

namespace rbpa::app {
namespace {

/// How a format writes lists of rings and of points.
struct Signs {
  std::string_view open_list, close_list;
  std::string_view open_point, between_coordinates, close_point;
  std::string_view between;
};
constexpr Signs geojson{"[", "]", "[", ",", "]", ","};
constexpr Signs wkt{"(", ")", "", " ", "", ", "};

void write_ring(OutputFile& file, const Ring& ring, std::span<const Point> points, const Signs& signs) {
  const auto write_point = [&](const Point& p) {
    file.write(signs.open_point);
    file.write_number(p.x);
    file.write(signs.between_coordinates);
    file.write_number(p.y);
    file.write(signs.close_point);
  };
  file.write(signs.open_list);
  for (const std::uint32_t i : ring.points) {
    write_point(points[i]);
    file.write(signs.between);
  }
  write_point(points[ring.points.front()]);  // closed
  file.write(signs.close_list);
}

void write_rings(OutputFile& file, const Polygon& polygon, std::span<const Point> points, const Signs& signs) {
  file.write(signs.open_list);
  write_ring(file, polygon.shell, points, signs);
  for (const Ring& hole : polygon.holes) {
    file.write(signs.between);
    write_ring(file, hole, points, signs);
  }
  file.write(signs.close_list);
}

void write_json_number(OutputFile& file, double value) {
  if (std::isfinite(value)) {
    file.write_number(value);
  } else {
    file.write("null");
  }
}

}  // namespace

void write_geojson(OutputFile& file, const Shape& shape) {
  const std::vector<std::size_t> points = points_in_polygons(shape);
  file.write("{\"type\":\"FeatureCollection\"," + crs_member(shape.crs) + "\"features\":[");
  std::string_view before = "\n";
  for (std::size_t i = 0; i < shape.polygons.size(); ++i) {
    const Polygon& polygon = shape.polygons[i];
    file.write(before);
    before = ",\n";
    file.write("{\"type\":\"Feature\",\"properties\":{\"number\":");
    file.write_number(std::uint64_t{i + 1});
    file.write(",\"area\":");
    write_json_number(file, polygon.area);
    file.write(",\"perimeter\":");
    write_json_number(file, polygon.perimeter);
    file.write(",\"holes\":");
    file.write_number(std::uint64_t{polygon.holes.size()});
    file.write(",\"points\":");
    file.write_number(std::uint64_t{points[i]});
    file.write("},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":");
    write_rings(file, polygon, shape.points, geojson);
    file.write("}}");
  }
  file.write("\n]}\n");
}

void write_wkt(OutputFile& file, const Shape& shape) {
  const std::span<const Polygon> polygons = shape.polygons;
  file.write(polygons.empty() ? "MULTIPOLYGON EMPTY" : "MULTIPOLYGON (");
  std::string_view before = "";
  for (const Polygon& polygon : polygons) {
    file.write(before);
    before = wkt.between;
    write_rings(file, polygon, shape.points, wkt);
  }
  file.write(polygons.empty() ? "\n" : ")\n");
}

}  // namespace rbpa::app

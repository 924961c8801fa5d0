#include "io/write_polygons.h"

#include <cmath>
#include <cstdint>
#include <string_view>

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

void write_geojson(OutputFile& file, std::span<const Polygon> polygons, std::span<const Point> points) {
  file.write("{\"type\":\"FeatureCollection\",\"features\":[");
  std::string_view before = "\n";
  for (const Polygon& polygon : polygons) {
    file.write(before);
    before = ",\n";
    file.write("{\"type\":\"Feature\",\"properties\":{\"area\":");
    write_json_number(file, polygon.area);
    file.write(",\"perimeter\":");
    write_json_number(file, polygon.perimeter);
    file.write(",\"holes\":");
    file.write_number(std::uint64_t{polygon.holes.size()});
    file.write("},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":");
    write_rings(file, polygon, points, geojson);
    file.write("}}");
  }
  file.write("\n]}\n");
}

void write_wkt(OutputFile& file, std::span<const Polygon> polygons, std::span<const Point> points) {
  file.write(polygons.empty() ? "MULTIPOLYGON EMPTY" : "MULTIPOLYGON (");
  std::string_view before = "";
  for (const Polygon& polygon : polygons) {
    file.write(before);
    before = wkt.between;
    write_rings(file, polygon, points, wkt);
  }
  file.write(polygons.empty() ? "\n" : ")\n");
}

}  // namespace rbpa::app

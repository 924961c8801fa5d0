#include "io/gis/polygon_writers.h"

#include <cmath>

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

void write_ring(OutputFile& file, const std::vector<Point>& ring, const Signs& signs) {
  const auto write_point = [&](const Point& p) {
    file.write(signs.open_point);
    file.write_number(p.x);
    file.write(signs.between_coordinates);
    file.write_number(p.y);
    file.write(signs.close_point);
  };
  file.write(signs.open_list);
  for (const Point& p : ring) {
    write_point(p);
    file.write(signs.between);
  }
  write_point(ring.front());  // closed
  file.write(signs.close_list);
}

void write_rings(OutputFile& file, const PolygonOutline& polygon, const Signs& signs) {
  file.write(signs.open_list);
  std::string_view before = "";
  for (const std::vector<Point>& ring : polygon.rings) {
    file.write(before);
    before = signs.between;
    write_ring(file, ring, signs);
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

GeojsonWriter::GeojsonWriter(OutputFile& file, const std::optional<Crs>& crs) : file_(file) {
  file_.write("{\"type\":\"FeatureCollection\"," + crs_member(crs) + "\"features\":[");
}

void GeojsonWriter::add(const PolygonOutline& polygon) {
  file_.write(number_ == 0 ? "\n" : ",\n");
  file_.write("{\"type\":\"Feature\",\"properties\":{\"number\":");
  file_.write_number(++number_);
  file_.write(",\"area\":");
  write_json_number(file_, polygon.area);
  file_.write(",\"perimeter\":");
  write_json_number(file_, polygon.perimeter);
  file_.write(",\"holes\":");
  file_.write_number(std::uint64_t{polygon.rings.size() - 1});
  file_.write(",\"points\":");
  file_.write_number(polygon.points);
  file_.write("},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":");
  write_rings(file_, polygon, geojson);
  file_.write("}}");
}

void GeojsonWriter::finish() { file_.write("\n]}\n"); }

void WktWriter::add(const PolygonOutline& polygon) {
  file_.write(any_ ? wkt.between : "MULTIPOLYGON (");
  any_ = true;
  write_rings(file_, polygon, wkt);
}

void WktWriter::finish() { file_.write(any_ ? ")\n" : "MULTIPOLYGON EMPTY\n"); }

}  // namespace rbpa::app

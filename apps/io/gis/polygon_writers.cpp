#include "io/gis/polygon_writers.h"

#include <cmath>
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

void write_ring(OutputFile& file, std::span<const Point> ring, const Signs& signs) {
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

void GeojsonWriter::begin(const PolygonFacts& facts) {
  file_.write(number_ == 0 ? "\n" : ",\n");
  file_.write("{\"type\":\"Feature\",\"properties\":{\"number\":");
  file_.write_number(++number_);
  file_.write(",\"area\":");
  write_json_number(file_, facts.area);
  file_.write(",\"perimeter\":");
  write_json_number(file_, facts.perimeter);
  file_.write(",\"holes\":");
  file_.write_number(facts.holes);
  file_.write(",\"points\":");
  file_.write_number(facts.points);
  file_.write("},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":");
  file_.write(geojson.open_list);
  any_ring_ = false;
}

void GeojsonWriter::ring(std::span<const Point> points) {
  if (any_ring_) file_.write(geojson.between);
  any_ring_ = true;
  write_ring(file_, points, geojson);
}

void GeojsonWriter::end() {
  file_.write(geojson.close_list);
  file_.write("}}");
}

void GeojsonWriter::finish() { file_.write("\n]}\n"); }

void WktWriter::begin(const PolygonFacts&) {
  file_.write(any_ ? wkt.between : "MULTIPOLYGON (");
  any_ = true;
  file_.write(wkt.open_list);
  any_ring_ = false;
}

void WktWriter::ring(std::span<const Point> points) {
  if (any_ring_) file_.write(wkt.between);
  any_ring_ = true;
  write_ring(file_, points, wkt);
}

void WktWriter::end() { file_.write(wkt.close_list); }

void WktWriter::finish() { file_.write(any_ ? ")\n" : "MULTIPOLYGON EMPTY\n"); }

}  // namespace rbpa::app

#include "io/polygon/shape_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>

#include "io/interrupt.h"

namespace rbpa::app {

std::vector<std::size_t> points_in_polygons(const Shape& shape) {
  std::vector<std::size_t> counts(shape.polygons.size(), 0);
  for (const std::optional<std::uint32_t>& polygon : shape.polygon_of)
    if (polygon) ++counts[*polygon];
  return counts;
}

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

namespace {

void write_pair(OutputFile& file, const Point& p, std::string_view between) {
  file.write_number(p.x);
  file.write(between);
  file.write_number(p.y);
}

/// Calls visit(index) for each point in no polygon.
template <typename Visit>
void for_each_isolated(const Shape& shape, const Visit& visit) {
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    if (!shape.polygon_of[i]) visit(i);
  }
}

}  // namespace

void write_points_csv(OutputFile& file, const Shape& shape) {
  file.write("x,y,polygon\n");
  for (std::size_t i = 0; i < shape.points.size(); ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    write_pair(file, shape.points[i], ",");
    file.write(",");
    if (shape.polygon_of[i]) file.write_number(std::uint64_t{*shape.polygon_of[i]} + 1);
    file.write("\n");
  }
}

void write_isolated_csv(OutputFile& file, const Shape& shape) {
  file.write("x,y,index\n");
  for_each_isolated(shape, [&](std::size_t i) {
    write_pair(file, shape.points[i], ",");
    file.write(",");
    file.write_number(std::uint64_t{i});
    file.write("\n");
  });
}

void write_isolated_geojson(OutputFile& file, const Shape& shape) {
  file.write("{\"type\":\"FeatureCollection\"," + crs_member(shape.crs) + "\"features\":[");
  std::string_view before = "\n";
  for_each_isolated(shape, [&](std::size_t i) {
    file.write(before);
    before = ",\n";
    file.write("{\"type\":\"Feature\",\"properties\":{\"index\":");
    file.write_number(std::uint64_t{i});
    file.write("},\"geometry\":{\"type\":\"Point\",\"coordinates\":[");
    write_pair(file, shape.points[i], ",");
    file.write("]}}");
  });
  file.write("\n]}\n");
}

void write_isolated_wkt(OutputFile& file, const Shape& shape) {
  std::string_view before = "MULTIPOINT (";
  for_each_isolated(shape, [&](std::size_t i) {
    file.write(before);
    before = ", ";
    file.write("(");
    write_pair(file, shape.points[i], " ");
    file.write(")");
  });
  file.write(before == ", " ? ")\n" : "MULTIPOINT EMPTY\n");
}

}  // namespace rbpa::app

#include "io/polygon/write_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <utility>

#include "io/interrupt.h"
#include "io/number.h"
#include "io/values_at.h"
#include "io/words.h"

namespace rbpa::app {

std::vector<std::size_t> points_in_polygons(const Shape& shape) {
  std::vector<std::size_t> counts(shape.polygons.size(), 0);
  for (const std::optional<std::uint32_t>& polygon : shape.polygon_of)
    if (polygon) ++counts[*polygon];
  return counts;
}

std::optional<std::string> geojson_caution(const Shape& shape) {
  if (shape.crs && !shape.crs->is_wgs84())
    return "written in " + shape.crs->text() +
           ", as its crs member says; readers that follow RFC 7946 take it for degrees of WGS 84 (ogr2ogr -t_srs "
           "EPSG:4326 "
           "converts it)";
  double x = 0, y = 0;
  for (const Point& p : shape.points) {
    x = std::max(x, std::abs(p.x));
    y = std::max(y, std::abs(p.y));
  }
  const double max_x = shape.degrees || shape.crs ? 360 : 180;  // longitudes may be shifted by 360
  if (x <= max_x && y <= 90) return std::nullopt;
  char size[64];
  std::snprintf(size, sizeof size, "%.6g and %.6g", x, y);
  return "coordinates go up to " + std::string(size) +
         ", but GeoJSON means degrees of WGS 84 (--crs EPSG:CODE names their system)";
}

bool is_cut_in_geojson(std::span<const Point> points, const std::optional<Crs>& crs, bool degrees) {
  return (degrees || (crs && crs->degrees)) && is_beyond_antimeridian(points);
}

/// The texts of a format before, between and after polygons, rings and points.
struct PolygonSigns {
  std::string_view first, next;  ///< before the first polygon, before any other
  bool has_properties;
  std::string_view open_list, close_list;
  std::string_view open_point, between_coordinates, close_point;
  std::string_view between;
  std::string_view close_polygon;
  std::string_view end, end_of_none;
};

namespace {

constexpr PolygonSigns geojson{"\n", ",\n", true, "[", "]", "[", ",", "]", ",", "}", "\n]}\n", "\n]}\n"};
constexpr PolygonSigns wkt{"MULTIPOLYGON (",      ", ", false, "(", ")", "", " ", "", ", ", "", ")\n",
                           "MULTIPOLYGON EMPTY\n"};
constexpr PolygonSigns wkt_collection{
    "GEOMETRYCOLLECTION (POLYGON ", ", POLYGON ", false, "(", ")", "", " ", "", ", ", "", ")\n",
    "GEOMETRYCOLLECTION EMPTY\n"};

/// Returns the member "crs" of the draft of 2008, and a comma; "" for WGS 84, the default of GeoJSON, and for an
/// unknown system.
std::string crs_member(const std::optional<Crs>& crs) {
  if (!crs || crs->is_wgs84()) return "";
  return "\"crs\":{\"type\":\"name\",\"properties\":{\"name\":\"" + crs->urn() + "\"}},";
}

/// Returns a number of JSON; "null" if the value is not finite, which JSON cannot express.
std::string finite_or_null(double value) { return std::isfinite(value) ? text_of(value) : "null"; }

/// Calls visit(corners) with the corners of the shell of a polygon, and of each of its holes.
template <typename Visit>
void for_each_ring(const Polygon& polygon, std::span<const Point> points, const Visit& visit) {
  std::vector<Point> corners;
  const auto gather = [&](const Ring& ring) {
    corners.clear();
    for (const std::uint32_t i : ring.points) corners.push_back(points[i]);
    visit(std::span<const Point>(corners));
  };
  gather(polygon.shell);
  for (const Ring& hole : polygon.holes) gather(hole);
}

void write_closed(OutputFile& file, const PolygonSigns& signs, std::span<const Point> ring) {
  const auto write_point = [&](const Point& p) {
    file.write_all(signs.open_point, p.x, signs.between_coordinates, p.y, signs.close_point);
  };
  file.write(signs.open_list);
  for (const Point& p : ring) {
    write_point(p);
    file.write(signs.between);
  }
  write_point(ring.front());
  file.write(signs.close_list);
}

}  // namespace

std::string geojson_collection(const std::optional<Crs>& crs) {
  return "{\"type\":\"FeatureCollection\"," + crs_member(crs) + "\"features\":[";
}

namespace {

void write_positions(OutputFile& file, const std::vector<PositionRing>& polygon, bool has_z) {
  std::string_view before_ring = "[";
  for (const PositionRing& ring : polygon) {
    file.write(std::exchange(before_ring, ","));
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Point3& p = ring[i % ring.size()];
      file.write_all(i == 0 ? "[[" : ",[", p.x, ",", p.y);
      if (has_z) file.write_all(",", p.z);
      file.write("]");
    }
    file.write("]");
  }
  file.write("]");
}

/// Writes polygons of GeoJSON with commas between them.
void write_parts(OutputFile& file, const std::vector<std::vector<PositionRing>>& parts, bool has_z) {
  std::string_view before = "";
  for (const std::vector<PositionRing>& part : parts) {
    file.write(std::exchange(before, ","));
    write_positions(file, part, has_z);
  }
}

PositionRing positions_of(std::span<const Point> ring) {
  PositionRing positions;
  for (const Point& p : ring) positions.push_back({p.x, p.y, 0});
  return positions;
}

}  // namespace

void write_geojson_polygon(OutputFile& file, const std::vector<PositionRing>& polygon, bool cuts, bool has_z) {
  std::vector<std::vector<PositionRing>> parts = {polygon};
  if (cuts) parts = within_antimeridian(polygon);
  const bool is_one = parts.size() == 1;
  file.write(is_one ? "{\"type\":\"Polygon\",\"coordinates\":" : "{\"type\":\"MultiPolygon\",\"coordinates\":[");
  write_parts(file, parts, has_z);
  file.write(is_one ? "}" : "]}");
}

PolygonWriter::PolygonWriter(OutputFile& file, Format format, const std::optional<Crs>& crs, bool cuts,
                             bool may_share_edges)
    : file_(file),
      signs_(format == Format::geojson ? geojson
             : may_share_edges         ? wkt_collection
                                       : wkt),
      cuts_(cuts && format == Format::geojson) {
  if (format == Format::geojson) file_.write(geojson_collection(crs));
}

void PolygonWriter::begin(const PolygonFacts& facts, std::string_view more) {
  file_.write(number_ == 0 ? signs_.first : signs_.next);
  ++number_;
  if (signs_.has_properties)
    file_.write_all("{\"type\":\"Feature\",\"properties\":{\"number\":", number_,
                    ",\"area\":", finite_or_null(facts.area), ",\"perimeter\":", finite_or_null(facts.perimeter),
                    ",\"holes\":", facts.holes, ",\"points\":", facts.points, more, "},\"geometry\":");
  rings_.clear();
  any_ring_ = false;
  if (cuts_) return;
  if (signs_.has_properties) file_.write("{\"type\":\"Polygon\",\"coordinates\":");
  file_.write(signs_.open_list);
}

void PolygonWriter::ring(std::span<const Point> points) {
  if (cuts_) return rings_.push_back(positions_of(points));
  if (any_ring_) file_.write(signs_.between);
  any_ring_ = true;
  write_closed(file_, signs_, points);
}

void PolygonWriter::end() {
  if (cuts_) {
    write_geojson_polygon(file_, rings_, true, false);
  } else {
    file_.write(signs_.close_list);
    if (signs_.has_properties) file_.write("}");
  }
  file_.write(signs_.close_polygon);
}

void PolygonWriter::finish() { file_.write(number_ == 0 ? signs_.end_of_none : signs_.end); }

void write_polygons(OutputFile& file, Format format, const Shape& shape) {
  PolygonWriter writer(file, format, shape.crs, is_cut_in_geojson(shape.points, shape.crs, shape.degrees),
                       shape.may_share_edges);
  const std::vector<std::size_t> counts = points_in_polygons(shape);
  for (std::size_t i = 0; i < shape.polygons.size(); ++i) {
    const Polygon& polygon = shape.polygons[i];
    writer.begin({polygon.area, polygon.perimeter, polygon.holes.size(), counts[i]}, json_members(shape.summaries, i));
    for_each_ring(polygon, shape.points, [&](std::span<const Point> ring) { writer.ring(ring); });
    writer.end();
  }
  writer.finish();
}

namespace {

/// Calls visit(i) for each point i in no polygon. Throws Cancelled.
template <typename Visit>
void for_each_isolated(const Shape& shape, const Visit& visit) {
  for (std::size_t i = 0; i < shape.polygon_of.size(); ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    if (!shape.polygon_of[i]) visit(i);
  }
}

/// Writes the rings of polygons with commas between them. If `cuts`, first cuts each polygon at longitudes ±180.
class RingWriter final : public PolygonSink {
 public:
  RingWriter(OutputFile& file, const PolygonSigns& signs, bool cuts) : file_(file), signs_(signs), cuts_(cuts) {}
  void begin(const PolygonFacts&) override {
    if (std::exchange(any_, true)) file_.write(signs_.between);
    before_ = signs_.open_list;
    to_cut_.clear();
  }
  void ring(std::span<const Point> points) override {
    if (cuts_) return to_cut_.push_back(positions_of(points));
    file_.write(std::exchange(before_, signs_.between));
    write_closed(file_, signs_, points);
  }
  void end() override {
    cuts_ ? write_parts(file_, within_antimeridian(to_cut_), false) : file_.write(signs_.close_list);
  }
  void finish() override {}

 private:
  OutputFile& file_;
  const PolygonSigns& signs_;
  bool cuts_, any_ = false;
  std::string_view before_ = {};
  std::vector<PositionRing> to_cut_ = {};
};

void show_polygons_of(const NamedShapes& groups, std::size_t group, PolygonSink& sink) {
  for (std::uint64_t i = groups.shapes.polygon_begin[group]; i < groups.shapes.polygon_begin[group + 1]; ++i) {
    sink.begin({});
    for_each_ring(groups.shapes.polygons[i], groups.points, [&](std::span<const Point> ring) { sink.ring(ring); });
    sink.end();
  }
}

/// Calls visit(group, problem) for each group; the problem is empty if the group has a polygon.
template <typename Visit>
void for_each_named(const NamedShapes& groups, const Visit& visit) {
  const std::vector<std::string_view> problems = problems_of(groups);
  for (std::size_t g = 0; g < problems.size(); ++g) {
    if (g % 256 == 0) stop_if_interrupted();
    visit(g, problems[g]);
  }
}

}  // namespace

std::vector<std::string_view> problems_of(const NamedShapes& groups) {
  std::vector<std::string_view> problems(groups.names.size());
  for (const GroupProblem& problem : groups.shapes.problems) problems[problem.group] = problem.what;
  return problems;
}

std::string json_name(const std::string& name, bool is_number) { return is_number ? name : json_text(name); }

GroupsWriter::GroupsWriter(OutputFile& file, const std::optional<Crs>& crs, bool cuts) : file_(file), cuts_(cuts) {
  file.write(geojson_collection(crs));
}

void GroupsWriter::write(const GroupFacts& group, const std::function<void(PolygonSink&)>& show) {
  file_.write_all(std::exchange(any_, true) ? ",\n" : "\n",
                  "{\"type\":\"Feature\",\"properties\":{\"group\":", group.name, ",\"points\":", group.points,
                  ",\"alpha\":", finite_or_null(group.alpha), ",\"area\":", finite_or_null(group.totals.area),
                  ",\"perimeter\":", finite_or_null(group.totals.perimeter), ",\"polygons\":", group.polygons,
                  group.more);
  if (!group.problem.empty()) file_.write(",\"problem\":" + json_text(group.problem));
  file_.write("},\"geometry\":{\"type\":\"MultiPolygon\",\"coordinates\":[");
  RingWriter rings(file_, geojson, cuts_);
  show(rings);
  file_.write("]}}");
}

void GroupsWriter::finish() { file_.write("\n]}\n"); }

void write_groups(GroupsWriter& writer, const NamedShapes& groups) {
  for_each_named(groups, [&](std::size_t g, std::string_view problem) {
    writer.write({json_name(groups.names[g], groups.are_numbers), groups.sizes[g], groups.shapes.alphas[g],
                  groups.shapes.totals[g], groups.shapes.polygon_begin[g + 1] - groups.shapes.polygon_begin[g],
                  json_members(groups.attributes, groups.first + g), problem},
                 [&](PolygonSink& sink) { show_polygons_of(groups, g, sink); });
  });
}

void write_groups_geojson(OutputFile& file, const NamedShapes& groups) {
  GroupsWriter writer(file, groups.crs, is_cut_in_geojson(groups.points, groups.crs, groups.degrees));
  write_groups(writer, groups);
  writer.finish();
}

void write_groups_csv(OutputFile& file, const NamedShapes& groups) {
  file.write_all("group,points,alpha,area,perimeter,polygons,problem,geometry", csv_names(groups.attributes), "\n");
  for_each_named(groups, [&](std::size_t g, std::string_view problem) {
    const double alpha = groups.shapes.alphas[g];
    file.write_all(csv_text(groups.names[g]), ",", groups.sizes[g], ",", std::isnan(alpha) ? "" : text_of(alpha), ",",
                   groups.shapes.totals[g].area, ",", groups.shapes.totals[g].perimeter, ",",
                   groups.shapes.polygon_begin[g + 1] - groups.shapes.polygon_begin[g], ",", csv_text(problem), ",");
    if (problem.empty()) {
      file.write("\"MULTIPOLYGON (");
      RingWriter rings(file, wkt, false);
      show_polygons_of(groups, g, rings);
      file.write(")\"");
    } else {
      file.write("MULTIPOLYGON EMPTY");
    }
    file.write_all(csv_values(groups.attributes, g), "\n");
  });
}

void write_points_csv(OutputFile& file, const Shape& shape) {
  const std::vector<Attribute> fields = attributes_of(shape.fields, {"x", "y", "polygon"});
  file.write_all("x,y,polygon", csv_names(fields), "\n");
  for (std::size_t i = 0; i < shape.polygon_of.size(); ++i) {
    if (i % 16384 == 0) stop_if_interrupted();
    file.write_all(shape.points[i].x, ",", shape.points[i].y, ",");
    if (shape.polygon_of[i]) file.write_number(std::uint64_t{*shape.polygon_of[i]} + 1);
    file.write_all(csv_values(fields, i), "\n");
  }
}

void write_isolated_csv(OutputFile& file, const Shape& shape) {
  const std::vector<Attribute> fields = attributes_of(shape.fields, {"x", "y", "index"});
  file.write_all("x,y,index", csv_names(fields), "\n");
  for_each_isolated(shape, [&](std::size_t i) {
    file.write_all(shape.points[i].x, ",", shape.points[i].y, ",",
                   renumbered(static_cast<std::uint32_t>(i), shape.index), csv_values(fields, i), "\n");
  });
}

void write_isolated_geojson(OutputFile& file, const Shape& shape) {
  file.write(geojson_collection(shape.crs));
  const bool cuts = is_cut_in_geojson(shape.points, shape.crs, shape.degrees);
  const std::vector<Attribute> fields = attributes_of(shape.fields, {"index"});
  std::string_view before = "\n";
  for_each_isolated(shape, [&](std::size_t i) {
    const Point& p = shape.points[i];
    file.write_all(std::exchange(before, ",\n"), "{\"type\":\"Feature\",\"properties\":{\"index\":",
                   renumbered(static_cast<std::uint32_t>(i), shape.index), json_members(fields, i),
                   "},\"geometry\":{\"type\":\"Point\",\"coordinates\":[", cuts ? within_antimeridian(p.x) : p.x, ",",
                   p.y, "]}}");
  });
  file.write("\n]}\n");
}

void write_isolated_wkt(OutputFile& file, const Shape& shape) {
  std::string_view before = "MULTIPOINT (";
  for_each_isolated(shape, [&](std::size_t i) {
    file.write_all(std::exchange(before, ", "), "(", shape.points[i].x, " ", shape.points[i].y, ")");
  });
  file.write(before == ", " ? ")\n" : "MULTIPOINT EMPTY\n");
}

namespace {

void write_value(OutputFile& file, double value) {
  constexpr double greatest = 9007199254740992.0;  // 2^53
  if (value >= 0 && value < greatest && std::trunc(value) == value)
    file.write_number(static_cast<std::uint64_t>(value));
  else
    file.write(finite_or_null(value));
}

}  // namespace

void write_triangles_geojson(OutputFile& file, const TriangleTable& triangles) {
  const bool cuts = is_cut_in_geojson(triangles.points, triangles.crs, triangles.degrees);
  file.write(geojson_collection(triangles.crs));
  for (std::size_t i = 0; i < triangles.count; ++i) {
    if (i % 4096 == 0) stop_if_interrupted();
    file.write_all(i == 0 ? "\n" : ",\n", "{\"type\":\"Feature\",\"properties\":{\"number\":", i + 1);
    for (const TriangleAttribute& attribute : triangles.attributes) {
      file.write_all(",", json_name(attribute.name, false), ":");
      attribute.text ? file.write(json_name(attribute.text(i), false)) : write_value(file, attribute.number(i));
    }
    file.write("},\"geometry\":");
    const auto [a, b, c] = triangles.corners(i);
    write_geojson_polygon(file, {{a, b, c}}, cuts, triangles.has_z);
    file.write("}");
  }
  file.write("\n]}\n");
}

}  // namespace rbpa::app

#include "io/gis/write_points.h"

#include <cstdint>
#include <string_view>

#include "io/gis/geojson_crs.h"
#include "io/interrupt.h"

namespace rbpa::app {
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

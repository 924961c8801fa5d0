#include "io/polygon/triangle_features.h"

#include <cmath>
#include <cstdint>

#include "io/interrupt.h"
#include "io/polygon/shape_files.h"

namespace rbpa::app {
namespace {

void write_value(OutputFile& file, double value) {
  constexpr double greatest = 9007199254740992.0;  // 2^53
  if (!std::isfinite(value))
    file.write("null");
  else if (value >= 0 && value < greatest && std::trunc(value) == value)
    file.write_number(static_cast<std::uint64_t>(value));
  else
    file.write_number(value);
}

}  // namespace

void write_triangles_geojson(OutputFile& file, const TriangleList& triangles) {
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

// What: writes triangles as features for geographic information systems, with heights and attributes: GeoJSON here,
//       other formats by GDAL (ogr.h).
// Law:  the bytes depend on the triangles alone; coordinates read back to the same doubles.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/bytes/output_file.h"
#include "io/crs.h"
#include "rbpa/base/point.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// A number or a text for each triangle.
struct TriangleAttribute {
  std::string name;
  std::function<double(std::size_t)> number = {};     ///< NaN for a triangle without
  std::function<std::string(std::size_t)> text = {};  ///< set if the attribute is a text
};

struct TriangleList {
  std::size_t count = 0;
  std::function<std::array<Point3, 3>(std::size_t)> corners = {};  ///< counter-clockwise
  bool has_z = false;                                              ///< positions have three numbers, not two
  std::vector<TriangleAttribute> attributes = {};
  std::span<const Point> points = {};  ///< all points of which corners are taken
  std::optional<Crs> crs = std::nullopt;
  bool degrees = false;  ///< x is a longitude and y a latitude
};

/// Writes a FeatureCollection with a Polygon for each triangle, whose properties are "number", from 1, and the
/// attributes.
void write_triangles_geojson(OutputFile& file, const TriangleList& triangles);

}  // namespace rbpa::app

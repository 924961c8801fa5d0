// What: polygons as files of geographic information systems, one after the other.
// Law:  the bytes depend on what is added alone; coordinates read back to the same doubles.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "io/crs.h"
#include "io/output_file.h"
#include "rbpa/core/point.h"

namespace rbpa::app {

/// A polygon by the points of its rings.
struct PolygonOutline {
  std::vector<std::vector<Point>> rings = {};  ///< the shell, then the holes; the first point is not repeated
  double area = 0;
  double perimeter = 0;
  std::uint64_t points = 0;  ///< in it and in none before it
};

/// GeoJSON (RFC 7946): a FeatureCollection with one Feature for each polygon, whose properties are "number", from 1,
/// "area", "perimeter", "holes", how many, and "points". An area beyond the range of double is null. A system other than
/// WGS 84 is a member "crs".
class GeojsonWriter {
 public:
  GeojsonWriter(OutputFile& file, const std::optional<Crs>& crs);
  void add(const PolygonOutline& polygon);
  void finish();

 private:
  OutputFile& file_;
  std::uint64_t number_ = 0;
};

/// Well-known text: one MULTIPOLYGON, or MULTIPOLYGON EMPTY.
class WktWriter {
 public:
  explicit WktWriter(OutputFile& file) : file_(file) {}
  void add(const PolygonOutline& polygon);
  void finish();

 private:
  OutputFile& file_;
  bool any_ = false;
};

}  // namespace rbpa::app

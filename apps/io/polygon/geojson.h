// What: points, or polygons, from GeoJSON (RFC 7946, and the "crs" of its draft), one text or a sequence of them, one a line
//       or so.
// Law:  a coordinate is the double nearest to its decimal text, -0 included.
// Cost: one pass, and no more memory than the points.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/point_file.h"
#include "io/polygon/polygon_file.h"
#include "rbpa/base/point.h"
#include "rbpa/shape.h"

namespace rbpa::app {

struct GeoJsonKind {
  int depth;    ///< brackets around a position, its own included
  bool points;  ///< Point or MultiPoint
  bool rings;   ///< the lists innermost end where they begin
};

/// Of the name of a geometry that has coordinates.
std::optional<GeoJsonKind> geojson_kind(std::string_view type);

/// Each step returns what is wrong, or null.
class GeoJsonGeometry {
 public:
  /// Its points will follow `first` others.
  explicit GeoJsonGeometry(std::size_t first) : first_(first) {}

  const char* open();
  const char* add(double coordinate);
  const char* close(std::vector<Point>& points, Heights& heights);

  /// Takes the points at which rings close away, and appends the polygons that rings make, if they are wanted. False when
  /// positions lay in other brackets than the kind has.
  bool finish(const GeoJsonKind& kind, std::vector<Point>& points, std::vector<Polygon>* polygons = nullptr) const;

 private:
  std::size_t first_;
  int open_ = 0;                 // brackets
  int depth_ = 0;                // of the positions so far; 0: none
  std::size_t coordinates_ = 0;  // in the position that is not at its end
  std::array<double, 3> position_{};
  std::vector<std::size_t> ends_ = {};   // of the innermost lists of positions, as counts of all points
  std::vector<std::size_t> lists_ = {};  // of these, as counts of ends
};

/// Those of Point and MultiPoint, and with `vertices` those of all geometries; the point at which a ring closes counts
/// once. Without "crs" they are longitudes and latitudes of WGS 84. Features without a geometry are counted in a remark.
/// Throws BadInput naming the line.
PointFile read_geojson_points(std::string_view text, const std::string& name, bool vertices);

/// The polygons of Polygon and MultiPolygon, each a geometry, of collections as well; anything else that has coordinates is
/// refused. A geometry outside of a Feature is a feature with those around it. Of properties those that are numbers.
PolygonFile read_geojson_polygons(std::string_view text, const std::string& name);

}  // namespace rbpa::app

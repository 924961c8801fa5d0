// What: the points of one GeoJSON geometry, from the brackets and numbers of its coordinates, before or after it is known
//       which kind it is.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "io/heights.h"
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

}  // namespace rbpa::app

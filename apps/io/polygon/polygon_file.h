// What: polygons as a file has them, and what the file says about them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/point_file.h"
#include "rbpa/shape.h"

namespace rbpa::app {

/// Polygons that are one geometry: they are to be a valid multipolygon.
struct PolygonGeometry {
  std::size_t first_polygon;  ///< it ends where the next begins
  std::size_t feature;
};

/// A property of features that is a number.
struct NumberProperty {
  std::string name;
  std::vector<double> values;  ///< of each feature; NaN where it has none, or other than a number
};

struct PolygonFile {
  PointFile vertices = {};             ///< in the order of the file
  std::vector<Polygon> polygons = {};  ///< on these; nothing but the rings is filled in, and these are as they are
  std::vector<PolygonGeometry> geometries = {};  ///< that have polygons, in the order of the file
  std::size_t features = 0;                      ///< those without polygons as well
  std::vector<NumberProperty> properties = {};   ///< in the order in which they come first

  /// Adds vertices to the last polygon, as its shell or as a hole.
  void add_ring(std::size_t begin, std::size_t end, bool is_shell) {
    Ring& ring = is_shell ? polygons.back().shell : polygons.back().holes.emplace_back();
    for (; begin < end; ++begin) ring.points.push_back(static_cast<std::uint32_t>(begin));
  }
  /// The polygons from `first` on, if there are any, are one geometry.
  void end_geometry(std::size_t first, std::size_t feature) {
    if (polygons.size() > first) geometries.push_back({first, feature});
  }
};

}  // namespace rbpa::app

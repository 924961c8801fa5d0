// What: the polygons of a file, with the facts that the file states about them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/point_file.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa::app {

/// Consecutive polygons that form one geometry and should be a valid multipolygon.
struct PolygonGeometry {
  std::size_t first_polygon;  ///< index of the first polygon; the polygons end where those of the next geometry begin
  std::size_t feature;
};

/// A property of features that is a number.
struct NumberProperty {
  std::string name;
  std::vector<double> values;  ///< a value for each feature; NaN if the feature has no such number
};

struct PolygonFile {
  PointFile vertices = {};             ///< vertices of all rings, in the order of the file
  std::vector<Polygon> polygons = {};  ///< rings of indices in `vertices`, unchecked; other members are not filled in
  std::vector<PolygonGeometry> geometries = {};  ///< geometries with polygons, in the order of the file
  std::size_t features = 0;                      ///< number of features, including those without polygons
  std::vector<NumberProperty> properties = {};   ///< properties, in the order of their first occurrence

  /// Adds the vertices from `begin` to `end` to the last polygon, as its shell or as a hole.
  void add_ring(std::size_t begin, std::size_t end, bool is_shell) {
    Ring& ring = is_shell ? polygons.back().shell : polygons.back().holes.emplace_back();
    for (; begin < end; ++begin) ring.points.push_back(static_cast<std::uint32_t>(begin));
  }
  /// Makes the polygons from number `first` on, if there are any, one geometry of `feature`.
  void end_geometry(std::size_t first, std::size_t feature) {
    if (polygons.size() > first) geometries.push_back({first, feature});
  }
};

}  // namespace rbpa::app

// What: polygons as a file has them, and what the file says about them.
#pragma once

#include <cstddef>
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
};

}  // namespace rbpa::app

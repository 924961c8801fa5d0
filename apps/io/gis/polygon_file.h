// What: polygons as a file has them, and what the file says about them.
#pragma once

#include <vector>

#include "io/point_file.h"
#include "rbpa/shape/polygons.h"

namespace rbpa::app {

struct PolygonFile {
  PointFile vertices = {};             ///< in the order of the file
  std::vector<Polygon> polygons = {};  ///< on these; nothing but the rings is filled in, and these are as they are
};

}  // namespace rbpa::app

// What: points, or polygons, from a file of well-known text: geometries one behind the other, most often one a line.
#pragma once

#include <string>
#include <string_view>

#include "io/gis/polygon_file.h"
#include "io/point_file.h"

namespace rbpa::app {

/// Those of POINT and MULTIPOINT, and with `vertices` those of all geometries. Throws BadInput naming the line.
PointFile read_wkt_points(std::string_view text, const std::string& name, bool vertices);

/// The polygons of POLYGON, MULTIPOLYGON and what else is made of rings. Throws BadInput naming the line, also where there
/// is anything else.
PolygonFile read_wkt_polygons(std::string_view text, const std::string& name);

}  // namespace rbpa::app

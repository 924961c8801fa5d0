// What: points, or polygons, from GeoJSON (RFC 7946, and the "crs" of its draft), one text or a sequence of them, one a line
//       or so.
// Law:  a coordinate is the double nearest to its decimal text, -0 included.
// Cost: one pass, and no more memory than the points.
#pragma once

#include <string>
#include <string_view>

#include "io/point_file.h"
#include "io/polygon/polygon_file.h"
#include "io/text/condition.h"

namespace rbpa::app {

/// Those of Point and MultiPoint, and with `vertices` those of all geometries; the point at which a ring closes counts
/// once. Without "crs" they are longitudes and latitudes of WGS 84. Features without a geometry are counted in a remark.
/// `properties` of a Feature are those of its points: a key that is a text, a number, true or false, and a number as a radius;
/// without them the key is empty, and the radius NaN. Throws BadInput naming the line.
PointFile read_geojson_points(std::string_view text, const std::string& name, bool vertices,
                              const GroupColumns& properties = {});

/// The polygons of Polygon and MultiPolygon, each a geometry, of collections as well; anything else that has coordinates is
/// refused. A geometry outside of a Feature is a feature with those around it. Of properties those that are numbers.
PolygonFile read_geojson_polygons(std::string_view text, const std::string& name);

}  // namespace rbpa::app

// What: reads points, or polygons, from GeoJSON (RFC 7946, and "crs" of the draft of 2008): one text or a sequence of
//       texts, such as one per line.
// Law:  a coordinate is the double nearest to its decimal text, -0 included.
// Cost: one pass, and the memory of the points.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/point_file.h"
#include "io/polygon/polygon_file.h"
#include "io/text/condition.h"

namespace rbpa::app {

/// Reads the points of Point and MultiPoint, and with `vertices` those of all geometries; the point at which a ring
/// closes counts once. Without "crs" points are longitudes and latitudes of WGS 84. A warning counts Features without a
/// geometry. Fields of a point are the `properties` of its Feature: texts, numbers, true or false. Throws BadInput that
/// names the line; Cancelled.
PointFile read_geojson_points(std::string_view text, const std::string& name, bool vertices,
                              const std::optional<Condition>& where = std::nullopt,
                              const std::optional<FieldChoice>& keeps = std::nullopt);

/// Reads each Polygon and MultiPolygon, also in collections, as a geometry, and the properties of Features that are
/// numbers. The geometries of a text outside of any Feature form one feature. Throws BadInput that names the line, also
/// for other kinds of geometries; Cancelled.
PolygonFile read_geojson_polygons(std::string_view text, const std::string& name);

}  // namespace rbpa::app

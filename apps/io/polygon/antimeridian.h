// What: cuts polygons and lines at longitude 180, as GeoJSON demands: all longitudes of the parts are within -180 to
//       180.
// Law:  longitudes beyond ±180 change by exactly 360. Parts of valid polygons are valid: a polygon is not cut, and not
//       moved, if rounded crossings of the antimeridian would make a part invalid.
// Source: RFC 7946, 3.1.9.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// A ring of longitudes, latitudes and heights; the first point is not repeated.
using PositionRing = std::vector<Point3>;

/// Returns whether some longitude (x) is beyond ±180, and none is beyond ±360.
bool is_beyond_antimeridian(std::span<const Point> points);

/// Returns the longitude from -180 to 180 of the same meridian. Requires: -540 ≤ longitude ≤ 540.
double within_antimeridian(double longitude);

/// Returns the parts of a polygon, each with its shell first, counter-clockwise, and then its holes, clockwise.
/// Requires: the rings of `polygon` have this order and these directions; longitudes are within ±360.
std::vector<std::vector<PositionRing>> within_antimeridian(const std::vector<PositionRing>& polygon);

/// Returns the parts of the line from `from` to `to`, in this direction. Requires: longitudes within ±360.
std::vector<std::vector<Point3>> within_antimeridian(const Point3& from, const Point3& to);

}  // namespace rbpa::app

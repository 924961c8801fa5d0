// What: polygons and lines around longitude 180 as GeoJSON has them: cut there, all longitudes within -180 to 180.
// Law:  a longitude beyond is another by 360, exactly; parts of valid polygons are valid. A polygon of which a part would not
//       be, as crossings of the antimeridian are rounded, stays whole.
// Source: RFC 7946, 3.1.9.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// Longitudes, latitudes and heights; the first point is not repeated.
using PositionRing = std::vector<Point3>;

/// Whether a longitude is beyond 180 or -180, and none beyond 360 or -360.
bool is_beyond_antimeridian(std::span<const Point> points);

/// Returns the equal longitude within -180 to 180.
double within_antimeridian(double longitude);

/// The parts of a polygon, each with its shell first, counter-clockwise, and then its holes, clockwise.
std::vector<std::vector<PositionRing>> within_antimeridian(const std::vector<PositionRing>& polygon);

/// The parts of a line.
std::vector<std::vector<Point3>> within_antimeridian(const Point3& from, const Point3& to);

}  // namespace rbpa::app

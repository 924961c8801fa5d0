// What: the unit of coordinates: feet, meters or degrees, and the warnings about degrees.
// Source: EPSG dataset 10.076, as PROJ 9.1.1 has it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/point_file.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// Returns EPSG's code of the unit of the system `code`: 9003, the US survey foot, or 9002, the foot; nothing if it is
/// no foot, or if the code was not assigned yet.
std::optional<unsigned> feet_of_epsg(unsigned code);

/// Returns "metre", "foot", "US survey foot" or "degree"; nothing if neither the file nor its system says which.
std::optional<std::string_view> unit_of(const PointFile& file);

/// Adds 360 to longitudes below 0 (`--shift-longitude`), so that points around the antimeridian are neighbors. Throws
/// BadInput for a longitude outside -180 to 360.
void shift_longitude(std::vector<Point>& points, const std::string& name);

/// Returns the warning about points in space whose x and y are said to be degrees; empty if there are no points.
std::string warning_on_degrees(const std::vector<Point3>& points);

/// Adds warnings: that degrees are lengths of different size in the plane; that points are on both sides of the
/// antimeridian, or are not in degrees.
void warning_on_degrees(PointFile& file);

}  // namespace rbpa::app

// What: finds the unit of coordinates: feet, meters or degrees; warns about degrees.
// Source: EPSG dataset 10.076, as PROJ 9.1.1 has it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/box.h"
#include "io/point_file.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// Returns EPSG's code of the unit of the system with EPSG's code `code`: 9003, the US survey foot, or 9002, the foot;
/// nothing if the unit is not a foot, or the dataset does not assign the code.
std::optional<unsigned> feet_of_epsg(unsigned code);

/// Returns "metre", "foot", "US survey foot" or "degree"; nothing if neither the file nor its coordinate system names
/// the unit.
std::optional<std::string_view> unit_of(const PointFile& file);

/// Adds 360 to longitudes below 0 (`--shift-longitude`), so that points around the antimeridian are neighbors. Throws
/// BadInput that names `name` for a longitude outside -180 to 360.
void shift_longitude(std::vector<Point>& points, const std::string& name);

/// Returns the warning about points in space whose x and y are said to be degrees; empty if there are no points.
std::string warning_on_degrees(const std::vector<Point3>& points);

/// Returns the warning about points in the plane, with this bounding box, that are said to be degrees.
std::string warning_on_degrees(const Box& box);

/// Adds warnings to `file` if file.degrees: that degrees of longitude and latitude have different lengths; that points
/// are on both sides of the antimeridian, or are not in degrees.
void warning_on_degrees(PointFile& file);

}  // namespace rbpa::app

// What: the unit that coordinates are in: feet, meters, or degrees, and what is to be said of these.
// Source: EPSG dataset 10.076, as PROJ 9.1.1 has it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/point_file.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// The unit of EPSG that the coordinates of system `code` are in: 9003, the US survey foot, or 9002, the foot; nothing
/// where it is no foot, or the code was not given out yet.
std::optional<unsigned> feet_of_epsg(unsigned code);

/// "metre", "foot", "US survey foot" or "degree"; nothing where neither the file nor its system says which.
std::optional<std::string_view> unit_of(const PointFile& file);

/// `--shift-longitude`: adds 360 to longitudes below 0, so that what lies around the antimeridian hangs together.
/// Throws BadInput when a longitude is none: beyond -180 to 360.
void shift_longitude(std::vector<Point>& points, const std::string& name);

/// What is to be said of points of space of which x and y are degrees and z is none; nothing where there are no such.
std::string remark_on_degrees(const std::vector<Point3>& points);

/// Adds remarks: what a degree is in the plane; that the points are on both sides of the antimeridian, or no degrees.
void remark_on_degrees(PointFile& file);

}  // namespace rbpa::app

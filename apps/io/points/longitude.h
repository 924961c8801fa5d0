// What: what is to be said of points that are longitudes and latitudes, in degrees.
#pragma once

#include <string>
#include <vector>

#include "io/point_file.h"
#include "rbpa/base/point3.h"

namespace rbpa::app {

/// `--shift-longitude`: adds 360 to longitudes below 0, so that what lies around the antimeridian hangs together.
/// Throws BadInput when a longitude is none: beyond -180 to 360.
void shift_longitude(PointFile& file, const std::string& name);

/// What is to be said of points of space of which x and y are degrees and z is none; nothing where there are no such.
std::string remark_on_degrees(const std::vector<Point3>& points);

/// Adds remarks: what a degree is in the plane; that the points are on both sides of the antimeridian, or no degrees.
void remark_on_degrees(PointFile& file);

}  // namespace rbpa::app

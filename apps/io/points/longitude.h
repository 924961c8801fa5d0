// What: what is to be said of points that are longitudes and latitudes, in degrees.
#pragma once

#include <string>

#include "io/point_file.h"

namespace rbpa::app {

/// `--shift-longitude`: adds 360 to longitudes below 0, so that what lies around the antimeridian hangs together.
/// Throws BadInput when a longitude is none: beyond -180 to 360.
void shift_longitude(PointFile& file, const std::string& name);

/// Adds remarks: what a degree is in the plane; that the points are on both sides of the antimeridian, or no degrees.
void remark_on_degrees(PointFile& file);

}  // namespace rbpa::app

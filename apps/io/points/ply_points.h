// What: points from the vertices of a PLY file, ASCII or binary.
#pragma once

#include <string>
#include <string_view>

#include "io/point_file.h"

namespace rbpa::app {

/// The properties x and y, of any number type, of the element "vertex". Everything else is passed over; in a binary file
/// it has to be there nevertheless, so that a cut file is noticed. Throws BadInput naming the line, or the point
/// (counted from 0); when the file is too short for what the header announces, before anything is allocated.
PointFile read_ply_points(std::string_view bytes, const std::string& name);

}  // namespace rbpa::app

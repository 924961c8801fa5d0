// What: points from the vertices of an ASCII OFF file; faces are not read.
#pragma once

#include <string>
#include <string_view>

#include "io/point_file.h"

namespace rbpa::app {

/// OFF with any of the prefixes ST, C, N, or none; one vertex a line, of which x and y count. Throws BadInput naming the
/// line, before anything is allocated when the file is too short for the vertices it announces.
PointFile read_off_points(std::string_view text, const std::string& name);

}  // namespace rbpa::app

// What: coordinates from the vertex lines of ASCII mesh files.
#pragma once

#include <string>

#include "io/lines.h"

namespace rbpa::app {

/// The next word of `rest`, the unread part of the current line of `lines`, as a finite number. Throws BadInput.
double take_coordinate(std::string_view& rest, const Lines& lines, const std::string& name);

}  // namespace rbpa::app

// What: parses --fill-holes, which chooses the holes of a surface to fill.
#pragma once

#include <string>

#include "rbpa/space/surface/curve_kinds.h"

namespace rbpa::app {

/// Parses "all": all holes; "rims": also the rims of sheets and of islands; "30": holes of at most 30 edges, a number
/// from 3; "length=2.5": holes of at most this length, above 0. Throws WrongUsage that names the option.
HoleChoice parse_fill_holes(const std::string& text);

}  // namespace rbpa::app

// What: the holes of a surface to fill: --fill-holes.
#pragma once

#include <string>

#include "rbpa/space/surface/curve_kinds.h"

namespace rbpa::app {

/// Parses "all"; "rims", which adds the rims of sheets and of islands; "30", curves of at most 30 edges; "length=2.5",
/// curves of at most this length. Throws WrongUsage that names the option.
HoleChoice parse_fill_holes(const std::string& text);

}  // namespace rbpa::app

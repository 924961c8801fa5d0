// What: the unit that coordinates are in.
// Source: EPSG dataset 10.076, as PROJ 9.1.1 has it.
#pragma once

#include <optional>
#include <string_view>

#include "io/point_file.h"

namespace rbpa::app {

/// "metre", "foot", "US survey foot" or "degree"; nothing where neither the file nor its system says which.
std::optional<std::string_view> unit_of(const PointFile& file);

}  // namespace rbpa::app

// What: points from a LAS file, uncompressed, versions 1.0 to 1.4, point formats 0 to 10: x and y of every record, or of
//       those that a condition selects.
// Cost: one pass.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/condition.h"
#include "io/point_file.h"

namespace rbpa::app {

/// Coordinates are as scaled_integer.h has them. Throws BadInput.
PointFile read_las_points(std::string_view bytes, const std::string& name, const std::optional<Condition>& where,
                          bool skip_invalid = false);

}  // namespace rbpa::app

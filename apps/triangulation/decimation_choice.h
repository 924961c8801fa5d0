// What: parses how many triangles a decimation leaves, and reports the decimation as text and JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "rbpa/space/simplify/decimate.h"

namespace rbpa::app {

/// Parses a number of triangles, such as "10000", at least 1, a share, such as "10%", above 0 and at most 100, or a
/// distance that is kept, such as "error=0.5", at least 0. Throws WrongUsage that names the option.
DecimationOptions parse_decimation(const std::string& option, const std::string& text);

/// Returns a number with six digits that is not less than the value.
std::string rounded_up(double value);

/// Returns "decimated from 5856 to 586 triangles, at most 0.5 from those before", rounded up, and if no edge is left to
/// collapse, why.
std::string decimated_text(const Decimation& counts);

/// Returns {"triangles_before", "triangles", "collapses", "distance": 0.5, "refused": {"double_edge": 3, ...}}.
nlohmann::ordered_json as_json(const Decimation& counts);

}  // namespace rbpa::app

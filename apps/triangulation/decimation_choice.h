// What: parses the target of a decimation, and reports a decimation as text and JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "rbpa/space/simplify/decimate.h"

namespace rbpa::app {

/// Parses the target of a decimation: a number of triangles from 1, such as "10000"; a share above 0 % and up to 100 %,
/// such as "10%"; or a largest distance from 0, such as "error=0.5". Throws WrongUsage that names `option`.
DecimationOptions parse_decimation(const std::string& option, const std::string& text);

/// Returns a number as text of six significant digits that is not less than `value`.
std::string rounded_up(double value);

/// Returns "decimated from 5856 to 586 triangles, at most 0.5 from those before", with the distance rounded up, if it
/// was measured; if no edge can be collapsed any more, the reasons follow.
std::string decimated_text(const Decimation& counts);

/// Returns {"triangles_before", "triangles", "collapses", "distance": 0.5 or null, "refused": {"double_edge": 3, ...}}.
nlohmann::ordered_json as_json(const Decimation& counts);

}  // namespace rbpa::app

// What: parses options of rbpa surface and meshtopo that choose components and holes of a surface, and the target of a
//       decimation; reports a decimation as text and JSON.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "rbpa/space/simplify/decimate.h"
#include "rbpa/space/surface/curve_kinds.h"
#include "rbpa/space/surface/surface_components.h"

namespace rbpa::app {

/// Parse --shell (outer, largest or all) and --keep-largest (a number of components, at least 1). Throw WrongUsage that
/// names the option.
ShellChoice parse_shell(const std::string& text);
std::size_t parse_keep_largest(const std::string& text);
/// Parses --drop-small. "50" sets choice.min_triangles, at least 1; "area=2.5" sets choice.min_area, above 0. Throws
/// WrongUsage and leaves `choice` unchanged for any other text.
void parse_drop_small(const std::string& text, ComponentChoice& choice);

/// Parses "all": all holes; "rims": also the rims of sheets and of islands; "30": holes of at most 30 edges, a number
/// from 3; "length=2.5": holes of at most this length, above 0. Throws WrongUsage that names the option.
HoleChoice parse_fill_holes(const std::string& text);

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

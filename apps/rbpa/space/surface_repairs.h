// What: writes suggested repairs of the holes of a surface as text and JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/space/repair/suggested_repairs.h"

namespace rbpa::app {

/// Returns how `repair` closes its hole: "closed by --radius 0.1,0.25" for a larger ball after `radii`.
std::string repair_text(const SuggestedRepair& repair, const std::vector<double>& radii);
/// Returns "closed: 3 by --fill-holes, 1 by nothing".
std::string repairs_text(std::span<const SuggestedRepair> repairs);

/// Returns `repair` as a JSON object: "kind", and the values that belong to this kind.
nlohmann::ordered_json as_json(const SuggestedRepair& repair);
/// Returns the number of repairs of each kind: {"turn_normals", "larger_ball", "filling", "none"}.
nlohmann::ordered_json counts_as_json(const std::vector<std::optional<SuggestedRepair>>& repairs);

}  // namespace rbpa::app

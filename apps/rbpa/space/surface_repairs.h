// What: formats suggested repairs of the holes of a surface as text and JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rbpa/space/repair/suggested_repairs.h"

namespace rbpa::app {

/// Returns a text that tells how `repair` closes its hole, such as "closed by --radius 0.1,0.25" for a ball of radius
/// 0.25 after `radii`; or why nothing closes the hole.
std::string repair_text(const SuggestedRepair& repair, const std::vector<double>& radii);
/// Returns the number of repairs of each kind as text: "closed: 3 by --fill-holes, 1 by nothing".
std::string repairs_text(std::span<const SuggestedRepair> repairs);

/// Returns `repair` as a JSON object: "kind", and the values that belong to this kind.
nlohmann::ordered_json as_json(const SuggestedRepair& repair);
/// Returns the number of repairs of each kind as JSON: {"turn_normals", "larger_ball", "filling", "none"}.
nlohmann::ordered_json counts_as_json(const std::vector<std::optional<SuggestedRepair>>& repairs);

}  // namespace rbpa::app

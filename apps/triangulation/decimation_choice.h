// What: parses how many triangles a decimation leaves, and reports the decimation as text and JSON.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "rbpa/space/simplify/decimate.h"

namespace rbpa::app {

/// A number of triangles, or a share of those that there are.
struct DecimationChoice {
  std::size_t faces = 0;
  std::optional<double> percent = {};

  /// Returns the number of triangles to leave of `given`.
  std::size_t faces_of(std::size_t given) const {
    return percent ? static_cast<std::size_t>(static_cast<double>(given) * (*percent / 100)) : faces;
  }
};

/// Parses "10000", at least 1, or "10%", above 0 and at most 100. Throws WrongUsage that names the option.
DecimationChoice parse_decimation(const std::string& option, const std::string& text);

/// Returns "decimated from 5856 to 586 triangles", and if more are left than were wanted, why.
std::string decimated_text(const Decimation& counts);

/// Returns {"triangles_before", "triangles", "collapses", "refused": {"double_edge": 3, ...}}.
nlohmann::ordered_json as_json(const Decimation& counts);

}  // namespace rbpa::app

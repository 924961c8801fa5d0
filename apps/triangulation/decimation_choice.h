// What: parses how many triangles a decimation leaves, and reports the decimation as text and JSON.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "rbpa/space/simplify/decimate.h"

namespace rbpa::app {

/// A number of triangles, a share of those that there are, or a distance that is kept.
struct DecimationChoice {
  std::size_t faces = 0;
  std::optional<double> percent = {};
  std::optional<double> error = {};

  /// Returns the number of triangles to leave of `given`.
  std::size_t faces_of(std::size_t given) const {
    return percent ? static_cast<std::size_t>(static_cast<double>(given) * (*percent / 100)) : faces;
  }
};

/// Parses "10000", at least 1, "10%", above 0 and at most 100, or "error=0.5", at least 0. Throws WrongUsage that names
/// the option.
DecimationChoice parse_decimation(const std::string& option, const std::string& text);

/// Returns "decimated from 5856 to 586 triangles, at most 0.5 from those before", rounded up, and if no edge is left to
/// collapse, why.
std::string decimated_text(const Decimation& counts);

/// Returns {"triangles_before", "triangles", "collapses", "distance": 0.5, "refused": {"double_edge": 3, ...}}.
nlohmann::ordered_json as_json(const Decimation& counts);

}  // namespace rbpa::app

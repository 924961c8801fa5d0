// What: counts filled holes, and unfilled holes by reason; formats the counts as text and JSON.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "rbpa/space/repair/refine_filling.h"

namespace rbpa::app {

/// Names of outcomes in JSON, indexed by HoleOutcome.
inline constexpr std::array outcome_names{"filled", "crosses", "edge_taken", "no_area", "too_much_work"};

struct FillingCounts {
  std::array<std::size_t, outcome_names.size()> holes = {};  ///< number of holes, by HoleOutcome
  std::size_t triangles = 0;                                 ///< number of new triangles
  double area = 0;                                           ///< total area of the new triangles
  std::size_t given_up = 0;  ///< number of triangles around holes that were removed so that holes can be filled
  std::size_t points = 0;    ///< number of points that refining added
  std::size_t smooth = 0;    ///< number of fillings whose added points were moved to continue the surface

  std::size_t filled() const { return holes[static_cast<std::size_t>(HoleOutcome::filled)]; }
  std::size_t left() const { return std::accumulate(holes.begin() + 1, holes.end(), std::size_t{0}); }
};

/// Returns the counts of `holes`, which may be in any order. `given_up`, `points` and `smooth` are 0.
FillingCounts count(std::span<const HoleFill> holes);

/// Sets `triangles`, `area`, `points` and `smooth` of `counts` after refining has changed the fillings. `is_new` tells
/// for each triangle whether it fills a hole.
void count_refined(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                   const std::vector<bool>& is_new, const AddedPoints& added, FillingCounts& counts);

/// Returns "3 holes filled by 12 triangles of area 0.5"; if refining added points, ", with 5 points added, 2 fillings
/// made smooth" follows.
std::string filled_text(const FillingCounts& counts);
/// Returns "2 holes not filled: 1 where any filling crosses the surface, 1 …". Requires: counts.left() > 0.
std::string left_text(const FillingCounts& counts);

/// Returns {"holes", "triangles", "area", "given_up", "left": {"crosses", "edge_taken", "no_area", "too_much_work"}}.
nlohmann::ordered_json as_json(const FillingCounts& counts);

}  // namespace rbpa::app

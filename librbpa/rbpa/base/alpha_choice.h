// What: a radius alpha or a rule that derives alpha from the points, and the spelling of rules.
// Law:  parse_alpha_rule(name_of(choice)) has the rule of `choice` and, for `plateau`, its rank; with rule `given` or
//       rank 0, it is nothing.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rbpa/base/api.h"

namespace rbpa {

/// A rule by which a radius is chosen.
enum class AlphaRule {
  given,      ///< the radius AlphaChoice::radius
  automatic,  ///< "auto": the least radius at which max_components solid components hold a share `cover` of the points
  least,      ///< "min": the least radius at which a share `cover` of the points is in the complex
  plateau     ///< "plateau", "plateau:K": a radius around which the shape hardly changes
};

/// A radius, or a rule with its parameters. The struct checks no value.
struct AlphaChoice {
  AlphaRule rule = AlphaRule::given;
  double radius = std::numeric_limits<double>::infinity();  ///< for `given`
  std::size_t max_components = 1;                           ///< for `automatic`; in space always 1
  double cover = 1;      ///< share of the distinct points, above 0 and at most 1, for `automatic` and `least`
  std::size_t rank = 1;  ///< for `plateau`: the rank of the plateau, from 1, the best
  friend bool operator==(const AlphaChoice&, const AlphaChoice&) = default;
};

/// Returns whether a rule reads AlphaChoice::max_components.
constexpr bool takes_components(AlphaRule rule) { return rule == AlphaRule::automatic; }
/// Returns whether a rule reads AlphaChoice::cover.
constexpr bool takes_cover(AlphaRule rule) { return rule == AlphaRule::automatic || rule == AlphaRule::least; }

/// The list of all spellings of a radius or a rule, for error messages.
inline constexpr std::string_view expected_alpha = "a radius (a number > 0, or inf), auto, min, plateau or plateau:K";

/// Parses "auto", "min", "plateau" or "plateau:K", where K is an integer from 1. Returns nothing for any other text,
/// and thus for a radius.
RBPA_API std::optional<AlphaChoice> parse_alpha_rule(std::string_view text);

/// Returns the spelling of the rule: "given", "auto", "min", "plateau", or with another rank than 1 "plateau:2".
RBPA_API std::string name_of(const AlphaChoice& choice);

/// Checks that the rank of the choice is from 1 to the number of plateaus.
/// Throws: InvalidInput when the rank is 0 or too large ("alpha plateau:4: there are only 3 plateaus").
RBPA_API void require_rank(const AlphaChoice& choice, std::size_t plateaus);

/// Returns the alpha of the plateau that has the rank of the choice; nothing if there is no plateau.
/// Requires: `plateaus` is sorted, the best first.
/// Throws:   InvalidInput as require_rank(), unless `plateaus` is empty.
template <typename Plateau>
std::optional<double> alpha_of_rank(const AlphaChoice& choice, const std::vector<Plateau>& plateaus) {
  if (plateaus.empty()) return std::nullopt;
  require_rank(choice, plateaus.size());
  return plateaus[choice.rank - 1].alpha;
}

}  // namespace rbpa

// What: chooses the radius of points in the plane by a rule.
// Law:  the radius is a function of the set of points and the choice, not of the order of the points.
// Cost: that of smallest_covering() or of filtration() and plateaus(); a given radius costs nothing.
#pragma once

#include <optional>
#include <vector>

#include "rbpa/base/alpha_choice.h"
#include "rbpa/base/api.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/plateaus.h"
#include "rbpa/plane/smallest_covering_alpha.h"

namespace rbpa {

struct ChosenAlpha {
  std::optional<double> alpha = std::nullopt;  ///< absent: the rule finds no radius, as on a line
  std::vector<Plateau> plateaus = {};          ///< all of them, the best first, if the rule is `plateau`
};

/// Returns the share of the points, and the maximum number of solid components that must hold this share, as the rule
/// `automatic` or `least` requires.
RBPA_API Covering covering_of(const AlphaChoice& choice);

/// Returns the given radius, or the radius that the rule chooses.
/// Throws: InvalidInput when the rank is 0 or above the number of plateaus, unless there is none; ContractViolation
///         when the cover is not above 0 and at most 1; Cancelled.
RBPA_API ChosenAlpha choose_alpha(const AlphaChoice& choice, const Delaunay& delaunay, const GoOn& go_on = {});

}  // namespace rbpa

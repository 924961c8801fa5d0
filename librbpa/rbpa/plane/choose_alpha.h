// What: chooses alpha for points in the plane by a rule.
// Law:  alpha is a function of the set of points and the choice.
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

/// The chosen radius, in units of the points.
struct ChosenAlpha {
  std::optional<double> alpha = std::nullopt;  ///< absent: the rule finds no radius, as for points on one line
  std::vector<Plateau> plateaus = {};          ///< the result of plateaus() if the rule is `plateau`; otherwise empty
};

/// Returns the requirement of the rule `automatic` or `least`: the share choice.cover of the points, in at most
/// choice.max_components solid components for `automatic`, in any number of components for `least`.
RBPA_API Covering covering_of(const AlphaChoice& choice);

/// Returns choice.radius, unchecked, if the rule is `given`; otherwise the radius that the rule chooses.
/// Throws: with `plateau`, InvalidInput when there are plateaus, but choice.rank is 0 or above their number; with
///         `automatic` or `least`, ContractViolation when choice.cover is not above 0 and at most 1; Cancelled.
RBPA_API ChosenAlpha choose_alpha(const AlphaChoice& choice, const Delaunay& delaunay, const GoOn& go_on = {});

}  // namespace rbpa

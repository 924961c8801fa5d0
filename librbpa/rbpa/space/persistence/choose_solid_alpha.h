// What: chooses alpha for points in space by a rule.
// Law:  the radius is a function of the set of points and the choice.
// Cost: that of min_alpha(), auto_alpha() or solid_plateaus(); a given radius costs nothing.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "rbpa/base/alpha_choice.h"
#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/persistence/solid_plateaus.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

/// The chosen radius, in units of the points.
struct ChosenSolidAlpha {
  double alpha = std::numeric_limits<double>::infinity();  ///< infinity if a rule finds no tetrahedron
  std::vector<SolidPlateau> plateaus = {};  ///< the result of solid_plateaus() if the rule is `plateau`; else empty
};

/// Returns choice.radius, unchecked, if the rule is `given`; otherwise the radius that the rule chooses. For
/// `automatic`, one component has to hold the cover; choice.max_components is not read.
/// Requires: unless the rule is `given`: `delaunay` is solid() of `points` at infinity, with neighbors, and `radii` are
///           its circumradii(). Unless the rule is `plateau`, `delaunay` may also be without_offsets() of a periodic
///           solid.
/// Throws:   as the function of the rule: min_alpha(), auto_alpha(), with choice.cover as the share, or
///           solid_plateaus(); with `plateau`, also InvalidInput when there are plateaus, but none of the rank.
RBPA_API ChosenSolidAlpha choose_solid_alpha(const AlphaChoice& choice, std::span<const Point3> points,
                                             const Solid& delaunay, std::span<const double> radii,
                                             const GoOn& go_on = {});

}  // namespace rbpa

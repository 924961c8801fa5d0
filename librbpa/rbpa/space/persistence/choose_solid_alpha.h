// What: chooses alpha for points in space by a given rule.
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
  std::vector<SolidPlateau> plateaus = {};                 ///< the result of solid_plateaus() if the rule is `plateau`
};

/// Returns choice.radius, unchecked, if the rule is `given`; otherwise the radius that the rule chooses. For
/// `automatic`, choice.max_components is not read: one component must have the share choice.cover of the points.
/// Requires: if the rule is not `given`, `delaunay` is solid() of `points` at infinity, with neighbors, and `radii` are
///           its circumradii(). Except for `plateau`, `delaunay` may also be without_offsets() of a periodic solid.
/// Throws:   exceptions of the function that the rule calls: min_alpha() or auto_alpha() with the share choice.cover,
///           or solid_plateaus(). For `plateau` also InvalidInput when there are plateaus, but none of the wanted rank.
RBPA_API ChosenSolidAlpha choose_solid_alpha(const AlphaChoice& choice, std::span<const Point3> points,
                                             const Solid& delaunay, std::span<const double> radii,
                                             const GoOn& go_on = {}, MaxThreads threads = 0);

}  // namespace rbpa

// What: chooses alpha for points in space by a rule.
// Law:  a function of the set of points and the rule.
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
  /// All plateaus, the best first, if the rule is `plateau`; else none.
  std::vector<SolidPlateau> plateaus = {};
};

/// Returns choice.radius if the rule is `given`, else the radius that the rule chooses.
/// Requires: unless the rule is `given`: `delaunay` is solid() of `points` at infinity, with neighbors, and `radii` are
///           its circumradii(). Unless the rule is `plateau`, `delaunay` may also be without_offsets() of a periodic
///           solid.
/// Throws:   InvalidInput when there are plateaus, but fewer than the rank; ContractViolation when the triangulation is
///           visibly of other points, or the cover is not above 0 and at most 1; Cancelled.
RBPA_API ChosenSolidAlpha choose_solid_alpha(const AlphaChoice& choice, std::span<const Point3> points,
                                             const Solid& delaunay, std::span<const double> radii,
                                             const GoOn& go_on = {});

}  // namespace rbpa

// What:   finds plateaus of points in space, and recommends an alpha in each. A plateau is a range of alpha with a
//         large ratio of its ends over which the components and voids of the solid alpha complex hardly change.
// Law:    plateaus are a function of the set of points alone. Scaling the points by a power of two scales the plateaus.
//         A few outliers or specks change the plateaus in proportion to their share of the points.
// Cost:   a few sorts of the tetrahedra; the rest is near-linear.
// Source: docs/explanation/filtration_and_persistence.md, section 8.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

/// A plateau: the radii with from ≤ radius < to, in units of the points, and measures of the complex at `alpha`.
struct SolidPlateau {
  double from = 0;
  std::optional<double> to = std::nullopt;  ///< no value for the plateau of the largest radii, which has no end
  /// The end of the plateau divided by `from`, but at least 1. The end is the lesser of `to`, if any, and half the
  /// diagonal of the points' bounding box.
  double ratio = 1;
  double alpha = 0;  ///< the recommended alpha: from · √ratio, but at most twice `from`
  // Measures of the complex at `alpha`:
  std::size_t tetrahedra = 0;  ///< number of tetrahedra in the complex
  std::size_t components = 0;  ///< components of the tetrahedra, connected through points
  std::size_t covered = 0;     ///< number of distinct points in tetrahedra
  double volume = 0;           ///< volume of the tetrahedra in the complex, in cubed units
  double effective_parts = 1;  ///< (Σ nᵢ)² / Σ nᵢ², with nᵢ the number of points of component i
  double void_share = 0;       ///< volume of voids / volume of tetrahedra and voids together
  /// Whether several components, or voids, are of significant size.
  bool is_structured = false;
  bool is_long = false;  ///< whether `ratio` is at least a bound that noise does not reach
  friend bool operator==(const SolidPlateau&, const SolidPlateau&) = default;
};

/// Returns at most eight plateaus, the best first. Let F be the long plateau with the least `from` that is not
/// structured. The first group has the long structured plateaus below F, or all if there is no F; the second F and the
/// long structured plateaus above F; the third all others. Each group is sorted by (ratio − 1) · (share of points
/// covered), descending. Plateaus that are not long and cover less than nine tenths of the points are last. At the
/// beginning of a plateau, at least half of the points are covered. The result is empty if there is no tetrahedron.
///
/// The *change* of the shape grows by at most a tenth within a plateau. Plateaus with a ratio below 1.25 are omitted,
/// unless there is no other. The change at alpha is the product P · H · E^(1/12) of
///   P  greatest Σ nᵢ² at any radius up to alpha;
///   H  product, over all radii up to alpha, of the factors ≥ 1 by which 1 − void_share rises or falls;
///   E  volume of tetrahedra and voids together.
/// Requires: `delaunay` is solid() of `points` at infinity, with neighbors; `radii` are its circumradii().
/// Calls `beside`, unless it is empty, once from any thread, while another one finds the plateaus.
/// Throws:   ContractViolation when the numbers of tetrahedra, rows of neighbors and radii differ, a corner is not a
///           point, or a neighbor no tetrahedron; Cancelled; what `beside` throws.
RBPA_API std::vector<SolidPlateau> solid_plateaus(std::span<const Point3> points, const Solid& delaunay,
                                                  std::span<const double> radii, const GoOn& go_on = {},
                                                  MaxThreads threads = 0,
                                                  const std::function<void(const GoOn&)>& beside = {});

}  // namespace rbpa

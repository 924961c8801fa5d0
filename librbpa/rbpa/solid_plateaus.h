// What:   plateaus of points in space: ranges of alpha, long as a ratio of their ends, over which parts and voids of the solid alpha complex hardly change; and in each
//         an alpha to choose.
// Law:    a function of the set of points alone; scaled points have the same plateaus, scaled. A few outliers, or dust, change it by as much as their share of the
//         points.
// Cost:   a few sorts of the tetrahedra; the rest is near-linear.
// Source: docs/which_alpha.md, section 6.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/solid.h"

namespace rbpa {

/// The alphas from ≤ alpha < to.
struct SolidPlateau {
  double from = 0;
  std::optional<double> to = std::nullopt;  ///< absent: it is the last, and has no end
  double ratio = 1;  ///< to / from; of the last, to half the diagonal of the points' box, at least 1
  double alpha = 0;  ///< in it, the one to choose: √(from · to), but at most twice `from`
  // There:
  std::size_t tetrahedra = 0;
  std::size_t components = 0;  ///< of the tetrahedra, connected through points
  std::size_t covered = 0;     ///< distinct points in tetrahedra
  double volume = 0;           ///< of the tetrahedra
  double effective_parts = 1;  ///< (Σ nᵢ)² / Σ nᵢ², with nᵢ the points of each component
  double void_share = 0;       ///< volume of voids / volume of tetrahedra and voids
  bool is_structured =
      false;  ///< several parts of weight, or voids of weight; else nearly all points that are covered are in one part
  bool is_long = false;  ///< its ratio is more than that which points without any structure reach by chance
  friend bool operator==(const SolidPlateau&, const SolidPlateau&) = default;
};

/// The best first, at most eight: long ones that are structured, below the first long one in one piece; then that one, and
/// long structured ones above it; then all others. Within each group by (ratio − 1) · share of points covered, descending.
/// Each begins where at least half of the points are covered, and within it the change grows by at most a tenth, which is the product P · H · E^(1/12), as in
/// rbpa/plateaus.h: P  Σ nᵢ², the greatest so far; H  all steps of 1 − void_share so far, each as a factor ≥ 1; E  the volume of tetrahedra and voids.
/// Returns: none when there is no tetrahedron.
/// Requires: the tetrahedra of solid() of these points at infinity, with neighbors, and their circumradii.
/// Throws:  ContractViolation where they visibly are not; Cancelled when `go_on`, which is called every few milliseconds, returns false. Empty: never called.
RBPA_API std::vector<SolidPlateau> solid_plateaus(std::span<const Point3> points, const Solid& delaunay,
                                                  std::span<const double> radii,
                                                  const std::function<bool()>& go_on = {});

}  // namespace rbpa

// What:   plateaus: ranges of alpha, long as a ratio of their ends, over which the parts and holes of the solid alpha
//         complex hardly change; and in each an alpha to choose.
// Law:    a function of the set of points alone; scaled points have the same plateaus, scaled. A few outliers, or dust,
//         change it by as much as their share of the points.
// Cost:   a sort of the triangles; the rest is near-linear. About as long as the filtration.
// Source: docs/which_alpha.md. Longest is most persistent: Edelsbrunner, Letscher, Zomorodian (2002); Betti curves that
//         stand still mark the scale of a sample: Robins, Meiss, Bradley (1998).
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/delaunay.h"
#include "rbpa/filtration.h"
#include "rbpa/triangulate.h"

namespace rbpa {

/// The form of a shape as a whole, regardless of tiny parts.
enum class PlateauKind {
  structured,  ///< several parts of weight, or holes of weight
  one_piece    ///< one part holds nearly all points that are covered, and holes are small
};

/// The alphas from ≤ alpha < to.
struct Plateau {
  double from = 0;
  std::optional<double> to = std::nullopt;  ///< absent: it is the last, and has no end
  double ratio = 1;  ///< to / from, its persistence; of the last, to half the diagonal of the points' box, at least 1
  double alpha = 0;  ///< in it, the one to choose: √(from · to), but at most plateau_settles · from
  FiltrationStep step = {};    ///< the complex at `alpha`
  double effective_parts = 1;  ///< there, (Σ nᵢ)² / Σ nᵢ², with nᵢ the vertices of each solid component
  double hole_share = 0;       ///< there, area of holes / area of complex and holes
  PlateauKind kind = PlateauKind::one_piece;  ///< there
  bool is_long = false;  ///< its ratio is more than that which points without any structure reach by chance
  friend bool operator==(const Plateau&, const Plateau&) = default;
};

/// The upper bound of Plateau::alpha / Plateau::from.
inline constexpr double plateau_settles = 2;

/// The best first, at most eight: long ones that are structured, below the first long one in one piece; then that one, and
/// long structured ones above it; then all others. Within each group by (ratio − 1) · share of points covered, descending.
/// Each begins where at least half of the points are covered.
/// Within a plateau the *change* of the shape grows by at most a tenth. Ranges with a ratio below 1.25 are left out, unless
/// there is no other. The change at alpha is the product P · H · ⁸√E of
///   P  Σ nᵢ², the greatest so far: how probable it is that two points are in one part;
///   H  the product of all steps of 1 − hole_share so far, each, up or down, as a factor ≥ 1;
///   E  the area of complex and holes, whose root lets it double, nearly, within a plateau.
/// Returns:  none when there is no triangle.
/// Requires: `filtration` is filtration(delaunay).
/// Throws:   ContractViolation when it is visibly of another triangulation; Cancelled when `go_on`, which is called every few
///           milliseconds, returns false. Empty: never called.
RBPA_API std::vector<Plateau> plateaus(const Delaunay& delaunay, const Filtration& filtration,
                                       const std::function<bool()>& go_on = {});
/// The same of triangulate(points, infinity, {.neighbors = true}), which is checked first, as by Delaunay.
inline std::vector<Plateau> plateaus(const Triangulation& delaunay, std::span<const Point> points,
                                     const Filtration& filtration, const std::function<bool()>& go_on = {}) {
  return plateaus(Delaunay(delaunay, points, go_on, "plateaus"), filtration, go_on);
}

}  // namespace rbpa

// What:   finds plateaus: ranges of alpha, long as a ratio of their ends, over which the parts and holes of the solid
//         alpha complex hardly change; and recommends an alpha in each.
// Law:    plateaus are a function of the set of points alone; points scaled by a power of two have the same plateaus,
//         scaled. A few outliers or specks change the plateaus in proportion to their share of the points.
// Cost:   a sort of the triangles; the rest is near-linear. About the time of the filtration.
// Source: docs/explanation/filtration_and_persistence.md, sections 6 and 7. Longest is most persistent: Edelsbrunner,
//         Letscher, Zomorodian (2002); Betti curves that stand still mark the scale of a sample: Robins, Meiss, Bradley
//         (1998).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/filtration.h"

namespace rbpa {

/// The form of a shape as a whole, regardless of tiny parts.
enum class PlateauKind {
  structured,  ///< several parts of significant size, or holes of significant size
  one_piece    ///< one part holds nearly all covered points, and holes are small
};

/// A plateau: the radii alpha with from ≤ alpha < to, in units of the points.
struct Plateau {
  double from = 0;
  std::optional<double> to = std::nullopt;  ///< absent: the plateau of the largest radii, which has no end
  /// Length of the plateau: its end divided by `from`, but at least 1. The end is `to`, or half the diagonal of the box
  /// of the points if that is less or the plateau has no end.
  double ratio = 1;
  double alpha = 0;            ///< the recommended alpha: from · √ratio, but at most plateau_settles · from
  FiltrationStep step = {};    ///< the complex at `alpha`
  double effective_parts = 1;  ///< at `alpha`, (Σ nᵢ)² / Σ nᵢ², with nᵢ the vertices of each solid component
  double hole_share = 0;       ///< at `alpha`, area of holes / area of complex and holes
  PlateauKind kind = PlateauKind::one_piece;  ///< at `alpha`
  bool is_long = false;  ///< whether `ratio` is above what points without any structure reach by chance
  friend bool operator==(const Plateau&, const Plateau&) = default;
};

/// The upper bound of Plateau::alpha / Plateau::from.
inline constexpr double plateau_settles = 2;

/// Returns at most eight plateaus, the best first. Let F be the long plateau of kind one_piece with the least `from`.
/// First come the long structured plateaus below F, or all long structured plateaus if there is no F; then F and the
/// long structured ones above F; then all others. Each group is sorted by (ratio − 1) · share of points covered,
/// descending; but plateaus that are not long and cover less than nine tenths of the points are last. At the beginning
/// of a plateau, at least half of the points are covered. The result is empty if there is no triangle.
///
/// The *change* of the shape grows by at most a tenth within a plateau. Ranges with a ratio below 1.25 are left out,
/// unless there is no other. The change at alpha is the product P · H · ⁸√E of
///   P  the greatest Σ nᵢ² up to alpha: the probability, up to a factor, that two points are in one part;
///   H  the product over all steps up to alpha of the factor ≥ 1 by which 1 − hole_share rises or falls;
///   E  the area of complex and holes; because of the eighth root, E may grow in a plateau by a factor of up to 2.1.
/// Requires: `filtration` is filtration(delaunay), of which only the numbers of triangles and points are checked.
/// Throws:   ContractViolation when one of these numbers differs; Cancelled.
RBPA_API std::vector<Plateau> plateaus(const Delaunay& delaunay, const Filtration& filtration, const GoOn& go_on = {});
/// Returns the plateaus of a triangulation that alpha_complex(points, infinity, {.neighbors = true}) returned.
/// Throws: as the first overload; ContractViolation as the constructor of Delaunay, which checks the triangulation.
inline std::vector<Plateau> plateaus(const AlphaComplex& delaunay, std::span<const Point> points,
                                     const Filtration& filtration, const GoOn& go_on = {}) {
  return plateaus(Delaunay(delaunay, points, go_on, "plateaus"), filtration, go_on);
}

}  // namespace rbpa

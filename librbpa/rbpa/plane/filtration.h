// What:   computes the solid alpha complex at every radius, from one Delaunay triangulation.
// Law:    the last step with step.alpha ≤ alpha holds the counts of rbpa(points, alpha), for every double alpha > 0;
//         below the alpha of the first step, the complex has no triangle. Exact, whatever the coordinates; steps are a
//         function of the set of points alone.
// Cost:   sorts the triangles; the rest is near-linear. About twice the time of the triangulation.
// Source: Edelsbrunner, Mücke, Three-dimensional alpha shapes (1994); docs/explanation/filtration_and_persistence.md.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/delaunay.h"

namespace rbpa {

/// The complex from one critical radius to the next: for `alpha` ≤ radius < alpha of the next step.
struct FiltrationStep {
  double alpha = 0;           ///< the critical radius, rounded up to a double; infinity if it is above all doubles
  std::size_t triangles = 0;  ///< number of triangles of the complex
  std::size_t solid_components = 0;  ///< components connected through edges
  std::size_t components = 0;        ///< components connected through points: pinches connect
  std::size_t holes = 0;             ///< bounded components of the complement in the plane
  std::size_t covered = 0;           ///< number of distinct points in triangles
  double area = 0;                   ///< area of the triangles, in squared units of the points, with rounding errors
  friend bool operator==(const FiltrationStep&, const FiltrationStep&) = default;
};

/// The steps of a filtration, and the radius of each triangle.
struct Filtration {
  std::vector<FiltrationStep> steps;   ///< strictly ascending in alpha and in triangles; empty without triangles
  std::vector<double> triangle_alpha;  ///< for each Delaunay triangle, its circumradius, rounded up to a double
  std::size_t distinct = 0;            ///< number of distinct points
};

/// Computes the filtration: sorts the triangles by circumradius and counts after each distinct radius.
/// Throws: Cancelled.
RBPA_API Filtration filtration(const Delaunay& of, const GoOn& go_on = {});
/// Computes the filtration of a triangulation that alpha_complex(points, infinity, {.neighbors = true}) returned.
/// Throws: ContractViolation as the constructor of Delaunay, which checks the triangulation; Cancelled.
inline Filtration filtration(const AlphaComplex& delaunay, std::span<const Point> points, const GoOn& go_on = {}) {
  return filtration(Delaunay(delaunay, points, go_on, "filtration"), go_on);
}

/// Returns the complex of radius alpha, 0 < alpha ≤ infinity: the result of alpha_complex(points, alpha, {.neighbors =
/// true}), without triangulating again.
/// Requires: `filtration` is filtration(of), of which only the numbers of triangles and of distinct points are checked.
/// Throws:   ContractViolation when one of these numbers differs, or alpha is not above 0.
/// Cost:     linear.
RBPA_API AlphaComplex complex_at(const Delaunay& of, const Filtration& filtration, double alpha);

/// Returns the least alpha at which every distinct point is in a triangle and, if `max_components` is given, there are
/// at most that many solid components. At a larger alpha there may be more components again. Returns nothing if there
/// is no such alpha: all points are on a line, as fewer than three always are, or `max_components` is 0.
/// Cost: linear in the number of steps.
RBPA_API std::optional<double> smallest_covering(const Filtration& filtration,
                                                 std::optional<std::size_t> max_components = std::nullopt);

}  // namespace rbpa

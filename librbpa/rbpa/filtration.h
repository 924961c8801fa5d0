// What:   the solid alpha complex at every radius, from one Delaunay triangulation.
// Law:    the last step with step.alpha ≤ alpha counts rbpa(points, alpha), for every double alpha > 0; before the
//         first step that complex is empty. Exact, whatever the coordinates; a function of the set of points alone.
// Cost:   sorts the triangles; the rest is near-linear. About twice the time of the triangulation.
// Source: Edelsbrunner, Mücke, Three-dimensional alpha shapes (1994); docs/filtration.md.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/delaunay.h"
#include "rbpa/triangulate.h"

namespace rbpa {

/// The complex from one critical radius to the next: for `alpha` ≤ radius < the next step's alpha.
struct FiltrationStep {
  double alpha = 0;           ///< least double radius at which the complex is this; infinity if no finite double is
  std::size_t triangles = 0;  ///< so far
  std::size_t solid_components = 0;  ///< pieces connected through edges
  std::size_t components = 0;        ///< pieces connected through points: pinches join
  std::size_t holes = 0;             ///< bounded components of its complement in the plane
  std::size_t covered = 0;           ///< distinct points in triangles
  double area = 0;                   ///< of the triangles so far: the only number here that is rounded
  friend bool operator==(const FiltrationStep&, const FiltrationStep&) = default;
};

struct Filtration {
  std::vector<FiltrationStep> steps;   ///< ascending in alpha and in triangles
  std::vector<double> triangle_alpha;  ///< of each Delaunay triangle, the least double alpha that admits it
  std::size_t distinct = 0;            ///< number of distinct points
};

/// The filtration of the points by circumradius.
/// Throws: Cancelled when `go_on`, which is called every few milliseconds, returns false. Empty: never called.
RBPA_API Filtration filtration(const Delaunay& of, const std::function<bool()>& go_on = {});
/// The same of triangulate(points, infinity, {.neighbors = true}), which is checked first, as by Delaunay.
inline Filtration filtration(const Triangulation& delaunay, std::span<const Point> points,
                             const std::function<bool()>& go_on = {}) {
  return filtration(Delaunay(delaunay, points, go_on, "filtration"), go_on);
}

/// The complex at a radius, 0 < alpha ≤ infinity: what triangulate(points, alpha, {.neighbors = true}) returns, without another
/// triangulation. Requires: the filtration is that of the triangulation.
/// Throws: ContractViolation when it is visibly of another one, or alpha is no radius. Cost: linear.
RBPA_API Triangulation complex_at(const Delaunay& of, const Filtration& filtration, double alpha);

/// The least alpha at which every distinct point is in a triangle; with `max_components`, at which moreover there are
/// at most that many solid components (their number is not monotone in alpha: it may exceed the bound again above).
/// Returns:  nothing when there is no such alpha: the points are fewer than three or on a line, or the bound is 0.
/// Cost:     linear in the number of steps.
RBPA_API std::optional<double> smallest_covering(const Filtration& filtration,
                                                 std::optional<std::size_t> max_components = std::nullopt);

}  // namespace rbpa

// What:   finds the least alpha at which at most K solid components contain a given share of the points, so that a few
//         outliers may be left out.
// Law:    with share 1 the result equals smallest_covering(filtration, max_components). The result never falls when the
//         share rises or K falls. The result is exact, and a function of the set of points, the share and K.
// Cost:   with a filtration, linear in its steps if components are not limited or share is 1. All other calls: n log n
//         in the triangles. Without a filtration and with share 1, only triangles above the radius that covers all
//         points are sorted.
// Source: docs/explanation/filtration_and_persistence.md, section 4.
#pragma once

#include <cstddef>
#include <optional>

#include "rbpa/base/api.h"
#include "rbpa/plane/alpha_complex.h"
#include "rbpa/plane/delaunay.h"
#include "rbpa/plane/filtration.h"

namespace rbpa {

/// A share of the points, and the number of components that may hold this share.
struct Covering {
  double share = 1;  ///< share of the distinct points, 0 < share ≤ 1
  /// Maximum number of solid components that together have this share; absent: any number.
  std::optional<std::size_t> max_components = std::nullopt;
};

/// Returns whether count / all, rounded to double, is at least `share`. A share written in decimals is therefore met
/// exactly: 7 of 100 is the share 0.07. Requires: `all` is above 0; not checked.
constexpr bool is_share(std::size_t count, std::size_t all, double share) {
  return static_cast<double>(count) / static_cast<double>(all) >= share;
}

/// Returns the least alpha at which at least the share of the distinct points is in triangles. With `max_components` K,
/// the number of these points, less the sizes of all solid components except the K largest, must also be at least this
/// share. The size of a component is its number of vertices in rbpa()'s mesh, where a point at which several fans meet
/// counts once for each fan. With K, a larger alpha may miss the share again, because of new components. The result is
/// rounded up to a double, infinity if it is above all doubles. Returns nothing if there is no such alpha: if all
/// points are on a line, as fewer than three always are, or if K is 0.
/// Requires: `filtration` is filtration(delaunay), of which only the numbers of triangles and points are checked.
/// Throws:   ContractViolation when one of these numbers differs, or the share is out of its bounds; Cancelled.
RBPA_API std::optional<double> smallest_covering(const Delaunay& delaunay, const Filtration& filtration,
                                                 const Covering& covering, const GoOn& go_on = {});
/// Returns the radius that the first overload returns. Needs no filtration, only the circumradii of the triangles, and
/// takes about half the time of filtration().
/// Throws: ContractViolation when the share is out of its bounds; Cancelled.
RBPA_API std::optional<double> smallest_covering(const Delaunay& delaunay, const Covering& covering,
                                                 const GoOn& go_on = {});
/// Returns the radius that the first overload returns, for the result of alpha_complex(points, infinity, {.neighbors =
/// true}).
/// Requires: `filtration` is the filtration of this triangulation.
/// Throws:   as the first overload; if the share is below 1 and components are limited, also ContractViolation as
///           require_linked(), as neighbors are read only then. Nothing else of the triangulation is checked.
RBPA_API std::optional<double> smallest_covering(const AlphaComplex& delaunay, const Filtration& filtration,
                                                 const Covering& covering, const GoOn& go_on = {});

}  // namespace rbpa

// What:   the least alpha at which a given number of components contain a given share of the points, so that outliers do
//         not decide it.
// Law:    with share 1 that of smallest_covering(filtration, max_components); the greater the share, and the fewer the
//         components, the greater the alpha. Exact; a function of the set of points alone.
// Cost:   linear in the steps without a bound on components, or without points left over; else it sorts the triangles,
//         and each then takes the logarithm of their number.
// Source: docs/which_alpha.md.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "rbpa/base/api.h"
#include "rbpa/delaunay.h"
#include "rbpa/filtration.h"
#include "rbpa/triangulate.h"

namespace rbpa {

struct Covering {
  double share = 1;                                          ///< of the distinct points: 0 < share ≤ 1
  std::optional<std::size_t> max_components = std::nullopt;  ///< solid components that hold them; absent: any number
};

/// `count` of `all` is at least this share: the quotient, rounded to double, is not below it. So a share written in
/// decimals is met exactly: 7 of 100 are the share 0.07.
constexpr bool is_share(std::size_t count, std::size_t all, double share) {
  return static_cast<double>(count) / static_cast<double>(all) >= share;
}

/// The least alpha at which the share of the distinct points is in triangles. With `max_components` K, the least at which
/// moreover that share is left when all solid components but the K largest are removed with all their points. The size of a
/// component is its number of vertices in rbpa()'s mesh, where a point in which several fans meet counts once for each.
/// Returns:  nothing when there is no such alpha: the points are fewer than three or on a line, or K is 0.
/// Requires: `filtration` is filtration(delaunay).
/// Throws:   ContractViolation when it is visibly of another triangulation, or the share is out of its bounds; Cancelled when
///           `go_on`, which is called every few milliseconds, returns false. Empty: never called.
RBPA_API std::optional<double> smallest_covering(const Delaunay& delaunay, const Filtration& filtration,
                                                 const Covering& covering, const std::function<bool()>& go_on = {});
/// The same where the filtration is wanted for nothing else: only its radii are computed, in about half the time.
RBPA_API std::optional<double> smallest_covering(const Delaunay& delaunay, const Covering& covering,
                                                 const std::function<bool()>& go_on = {});
/// The same of triangulate(points, infinity, {.neighbors = true}), where its neighbors matter checked by require_linked().
RBPA_API std::optional<double> smallest_covering(const Triangulation& delaunay, const Filtration& filtration,
                                                 const Covering& covering, const std::function<bool()>& go_on = {});

}  // namespace rbpa

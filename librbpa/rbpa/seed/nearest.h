// What: the nearest other point within reach of the ball.
// Law:  exact; among equally near points any one may be returned.
// Cost: constant on average for bounded variation of density.
#pragma once

#include <cstdint>
#include <optional>

#include "rbpa/predicate/radius.h"
#include "rbpa/search/point_grid.h"

namespace rbpa {

/// The site nearest to site v, unless it is farther than 2 alpha or there is none.
template <typename Real>
std::optional<std::uint32_t> nearest(const PointGrid<Real>& grid, const Radius& radius, std::uint32_t v) {
  using P = Predicates<Real>;
  constexpr Real inflated = 1 + 64 * P::unit;
  const auto points = grid.points();
  const Point& centre = points[v];
  std::optional<std::uint32_t> best;
  const auto look = [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t i = first; i < last; ++i)
      if (i != v && (!best || P::compare_distances(centre, points[i], points[*best]) < 0)) best = i;
  };
  const Real farthest = radius.is_infinite() ? grid.diameter_bound() : 2 * Real(radius.value()) * inflated;
  for (Real reach = grid.cell_size();; reach *= 2) {
    const Real r = std::min(reach, farthest);
    grid.scan(Region<Real>::disc({Real(centre.x), Real(centre.y)}, r), look);
    if (best) {
      // What was found may lie in a corner of a cell: nothing nearer is left once the disc up to it has been seen.
      const auto to_best = P::from(centre, points[*best]);
      const Real distance = std::sqrt(P::dot(to_best, to_best)) * inflated;
      if (distance > r) grid.scan(Region<Real>::disc({Real(centre.x), Real(centre.y)}, distance), look);
      break;
    }
    if (reach >= farthest) break;
  }
  if (!best || !radius.spans<Real>(centre, points[*best])) return std::nullopt;
  return best;
}

}  // namespace rbpa

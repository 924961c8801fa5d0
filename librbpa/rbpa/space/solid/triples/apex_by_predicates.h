// What: finds by exact predicates the fourth corner of the tetrahedron on one side of a triangle of sites.
// Law:  exact, under the symbolic perturbation (predicate/sphere.h).
// How:  any point on the side is the first apex. Each point on the side that is inside the ball of the current apex
//       becomes the apex: on this side the balls through the triangle shrink from one apex to the next. There is a
//       tetrahedron if the last ball is not larger than alpha, and no point on either side is inside.
// Cost: linear in the number of points, with at most three predicates for each; a predicate takes ten nanoseconds, or
//       microseconds where points are cospherical.
#pragma once

#include <optional>
#include <span>

#include "rbpa/space/cells/cells.h"
#include "rbpa/space/predicate/exact.h"
#include "rbpa/space/predicate/orientation.h"
#include "rbpa/space/predicate/sphere.h"

namespace rbpa::space {

/// Returns the site p of `around` for which (a, b, c, p) is a Delaunay tetrahedron of circumradius at most alpha, with
/// p on the side of the plane from which a, b and c are counter-clockwise. Returns nothing if there is no such site.
/// Requires: `around` has all sites within 2 alpha of a; a, b and c are not on a line.
inline std::optional<Site> exact_apex(std::span<const Point3> sites, std::span<const Site> around, double alpha, Site a,
                                      Site b, Site c) {
  std::optional<Site> apex;
  for (const Site p : around) {
    if (p == a || p == b || p == c || orientation(sites[a], sites[b], sites[c], sites[p]) <= 0) continue;
    if (!apex || in_sphere(sites[a], sites[b], sites[c], sites[*apex], sites[p])) apex = p;
  }
  if (!apex || exact::compare_circumradius(sites[a], sites[b], sites[c], sites[*apex], alpha) > 0) return std::nullopt;
  for (const Site p : around)
    if (p != a && p != b && p != c && p != *apex && in_sphere(sites[a], sites[b], sites[c], sites[*apex], sites[p]))
      return std::nullopt;
  return apex;
}

}  // namespace rbpa::space

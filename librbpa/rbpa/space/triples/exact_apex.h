// What: the fourth corner of the tetrahedron on a side of a triangle of sites, by predicates.
// Law:  exact, under the symbolic perturbation (predicate/sphere.h).
// How:  of the points on the side, each that is inside the ball of the one found before replaces it: the balls through the
//       triangle grow on that side from one to the next. Then no point at all may be inside.
// Cost: linear in the number of points, some of them a predicate of ten nanoseconds, or of microseconds where points are
//       cospherical.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "rbpa/space/cells/cells.h"

namespace rbpa::space {

/// The site p, of those around, with which a, b and c are a tetrahedron of the Delaunay triangulation of circumradius at most
/// alpha, p being on the side of their plane from which they are counter-clockwise. Nothing if there is none.
/// Requires: all sites within 2 alpha of a are around; a triangle.
std::optional<Site> exact_apex(std::span<const Point3> sites, std::span<const Site> around, double alpha, Site a,
                               Site b, Site c);

}  // namespace rbpa::space

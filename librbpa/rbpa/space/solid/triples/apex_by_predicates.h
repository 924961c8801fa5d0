// What: finds the fourth corner of the tetrahedron on a side of a triangle of sites, by predicates.
// Law:  exact, under the symbolic perturbation (predicate/sphere.h).
// How:  each point on the side that is inside the ball of the apex so far becomes the apex: on that side the balls
//       through the triangle grow from one apex to the next. In the end, no point at all may be inside.
// Cost: linear in the number of points; for some of them a predicate of ten nanoseconds, or of microseconds where
//       points are cospherical.
#pragma once

#include <optional>
#include <span>

#include "rbpa/space/cells/cells.h"

namespace rbpa::space {

/// Returns the site p of `around` for which (a, b, c, p) is a Delaunay tetrahedron of circumradius at most alpha, with
/// p on the side of the plane of a, b and c from which they are counter-clockwise; nothing if there is no such site.
/// Requires: `around` has all sites within 2 alpha of a; a, b and c are not on a line.
std::optional<Site> exact_apex(std::span<const Point3> sites, std::span<const Site> around, double alpha, Site a,
                               Site b, Site c);

}  // namespace rbpa::space

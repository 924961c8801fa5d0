// What: which shells the ball touches from outside everything.
// Law:  a shell is outer if no shell winds around the centre of a ball that rests on it, which is at least the radius away from
//       all points. Exact but for the rounding of that centre: where the radius is above 10⁻⁹ of the coordinates, only what is
//       nearly a ball's great circle is in doubt. docs/surface_derivation.md, section 13.
// Cost: a sort of the shells, and for each triangle a search among them.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"
#include "rbpa/surface_components.h"

namespace rbpa {

/// Of each component, whether it is outer: then neither another one nor it itself encloses the ball that rolls on it. A scan
/// of a closed object has one shell that is, and one that is not, on which the ball rolls inside.
/// Requires: the exposed_triangles() of these points and radius, and its components. Throws: ContractViolation on others.
RBPA_API std::vector<bool> outer_shells(std::span<const Point3> points, double radius, const Surface& shells,
                                        const SurfaceComponents& components);

}  // namespace rbpa

// What:   radii for points in space where the user gives none, from the gaps between neighbors along the surface.
// Law:    a function of the set of points, and of no order or thread; points scaled by a power of two have scaled radii. That
//         the radii are good ones is experience, not proof. docs/surface.md, section 4.
// Cost:   some microseconds a point, for its nearest neighbors.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa {

/// At most four radii, ascending. The last one spans the gaps between neighbors everywhere, except gaps much larger than
/// nearly all others and gaps beyond the neighbors, which may be holes. Where less than half of a radius is enough around one
/// point in twenty, a smaller one precedes it; where densities differ much, the steps are larger. Empty for points on a line,
/// and for fewer than three distinct ones.
/// Requires: finite points, fewer than 2^32 − 1.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API std::vector<double> auto_radii(std::span<const Point3> points, const SurfaceOptions& options = {});

/// The first of auto_radii() with which surface() has triangles, if there is one; without normals, exposed_triangles().
/// Throws:   as surface().
RBPA_API std::optional<double> radius_with_triangles(std::span<const Point3> points, std::span<const Point3> normals,
                                                     const SurfaceOptions& options = {});

}  // namespace rbpa

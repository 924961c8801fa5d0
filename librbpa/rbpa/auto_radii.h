// What:   radii for points of space for which the user has none, from the gaps between neighbours along the surface.
// Law:    a function of the set of points: of no order, no thread; points scaled by a power of two have scaled radii. What a
//         radius is good for is experience, not proof. docs/surface_derivation.md, section 12.
// Cost:   the nearest points of each point, some microseconds a point.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa {

/// At most four radii, ascending. The last one spans the gaps between neighbours everywhere, but for those that are much
/// larger than nearly all, and those that reach beyond the neighbours, which may be holes. Where half of a radius would do around
/// one point in twenty, or a third where densities differ much, there is one before it that does there. None for points on a
/// line, and for fewer than three distinct ones.
/// Requires: finite points, fewer than 2^32 − 1.
/// Throws:   InvalidInput naming what is not; Cancelled.
RBPA_API std::vector<double> auto_radii(std::span<const Point3> points, const SurfaceOptions& options = {});

/// For a surface without triangles: the first of auto_radii() with which surface() has some, if there is one. Without normals:
/// with which exposed_triangles() has.
/// Throws:   as surface().
RBPA_API std::optional<double> radius_with_triangles(std::span<const Point3> points, std::span<const Point3> normals,
                                                     const SurfaceOptions& options = {});

}  // namespace rbpa

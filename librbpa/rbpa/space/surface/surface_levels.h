// What:   computes the surface of points in space by several radii: a larger radius closes gaps that smaller ones leave
//         open.
// Law:    a function of the set of points, their normals and the radii, not of any order or thread. The result is an
//         oriented 2-manifold with boundary if each fan has a vertex of its own; its triangles never cross. A radius
//         adds triangles, removes none, and changes no gluing between earlier ones. docs/explanation/surfaces.md,
//         section 17.
// Source: Bernardini et al., section 4.4, use radii in ascending order; the rule of this function differs from theirs.
#pragma once

#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa {

/// Computes the surface() of the first radius. For each further radius, adds those triangles of its surface that touch
/// no interior point and no interior edge of the surface of the smaller radii: no point around which a fan is closed,
/// and no edge at which two sides are glued. Surface::levels has for each triangle the number of its radius, from 0,
/// also if there is a single radius.
/// Requires: what surface() requires; at least one radius, strictly ascending.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
/// Cost:     that of surface() for the first radius; for each further radius, that of surface() for the points near
///           points that are not interior.
RBPA_API Surface surface(std::span<const Point3> points, std::span<const Point3> normals, std::span<const double> radii,
                         const SurfaceOptions& options = {});

}  // namespace rbpa

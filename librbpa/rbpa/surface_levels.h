// What:   the surface of points in space by several radii: a greater one closes what the smaller ones left open.
// Law:    a function of the set of points, their normals and the radii: of no order, no thread. An oriented 2-manifold with
//         boundary, each fan a vertex of its own; its triangles never cross. What a radius has made is the surface of it and those
//         before it: nothing is taken away, and nothing glued otherwise. docs/surface_derivation.md, section 9.
// Source: Bernardini et al., section 4.4, has radii in ascending order; the rule here is another one.
#pragma once

#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/surface.h"

namespace rbpa {

/// surface() of the first radius; then, with each of the others, those triangles of its surface that touch no interior point
/// and no interior edge of what there is. Surface::levels says which radius made a triangle.
/// Requires: as surface(); at least one radius, ascending.
/// Throws:   as surface().
/// Cost:     of the first radius that of surface(); of the others, that of the points near to those that are not interior.
RBPA_API Surface surface(std::span<const Point3> points, std::span<const Point3> normals, std::span<const double> radii,
                         const SurfaceOptions& options = {});

}  // namespace rbpa

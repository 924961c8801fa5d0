// What:   volume and surface area of the union of equal balls around points.
// How:    inclusion and exclusion over the full alpha complex. A simplex counts by the angle around it that no
//         tetrahedron fills, so at most three balls have to be intersected. docs/explanation/space.md, section 21, has
//         the formula and a drawing.
// Law:    the set of balls that count is exact; sizes and angles are rounded, their sum is exact.
// Cost:   that of a Delaunay triangulation, which takes most of it.
// Source: Edelsbrunner, The union of balls and its dual shape (1995).
#pragma once

#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

struct BallUnion {
  double volume = 0, area = 0;
};

/// Computes volume and area of the union. Points may have any position; equal points count once.
/// Requires: finite points; 0 < radius < infinity.
/// Throws:   InvalidInput that names the violated requirement; as solid().
RBPA_API BallUnion union_of_balls(std::span<const Point3> points, double radius, const SolidOptions& options = {});

/// Computes the same from a triangulation that is already computed.
/// Requires: the result of solid() at infinity, with neighbors and with tetrahedra, and its circumradii().
/// Throws:   ContractViolation otherwise.
RBPA_API BallUnion union_of_balls(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                                  double radius, unsigned threads = 0);

}  // namespace rbpa

// What:   computes the volume and surface area of the union of equal balls around points.
// How:    computes like measure_balls(), on the full alpha complex, which is the dual complex of equal balls.
//         docs/explanation/space.md, section 24.
// Law:    the result is that of measure_balls() with equal radii. The choice of simplices is exact, sizes and angles
//         are rounded, and their sum is exact and rounded once.
// Cost:   that of a Delaunay triangulation, and about linear in its tetrahedra.
// Source: Edelsbrunner, The union of balls and its dual shape (1995).
#pragma once

#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa {

/// Volume and surface area of a union of balls. The volume is in the unit of the coordinates to the third power, the
/// area in that unit squared.
struct BallUnion {
  double volume = 0, area = 0;
};

/// Computes volume and area of the union; 0 without points. Equal points count once. Ignores options.neighbors.
/// Requires: finite points; 0 < radius < infinity. If all points are in one plane, points farther away than all balls
///           must still fit double.
/// Throws:   InvalidInput that names the violated requirement; what solid() throws.
RBPA_API BallUnion union_of_balls(std::span<const Point3> points, double radius, const SolidOptions& options = {});

/// Computes volume and area of the union from a triangulation that is already computed.
/// Requires: 0 < radius < infinity; `delaunay` is the result of solid(points, infinity), with neighbors, and has
///           tetrahedra; `radii` are its circumradii() of solid_radii.h.
/// Throws:   InvalidInput when the radius is out of range; ContractViolation when there are no tetrahedra or no
///           neighbors, or not as many radii as tetrahedra. The other requirements are not checked.
/// Cost:     about linear in the tetrahedra.
RBPA_API BallUnion union_of_balls(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                                  double radius, MaxThreads threads = 0);

}  // namespace rbpa

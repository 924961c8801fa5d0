// What:   volume and surface area of the union of equal balls around points.
// How:    inclusion and exclusion over the full alpha complex, whose simplices count by the angle that tetrahedra leave to them: no
//         more than three balls have to be intersected. docs/solid.md, section 11, has the formula and a drawing.
// Law:    which balls count is exact; sizes and angles are rounded, their sum is exact.
// Cost:   that of a Delaunay triangulation, which takes most of it.
// Source: Edelsbrunner, The union of balls and its dual shape (1995).
#pragma once

#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/solid.h"

namespace rbpa {

struct BallUnion {
  double volume = 0, area = 0;
};

/// Of points in any position; of equal ones one counts.
/// Requires: finite points; 0 < radius < infinity. Throws: InvalidInput that names the violated requirement; what solid() throws.
RBPA_API BallUnion union_of_balls(std::span<const Point3> points, double radius, const SolidOptions& options = {});

/// The same, with a triangulation that is there already.
/// Requires: the result of solid() at infinity, with neighbors and with tetrahedra, and its circumradii(). Throws ContractViolation otherwise.
RBPA_API BallUnion union_of_balls(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                                  double radius, unsigned threads = 0);

}  // namespace rbpa

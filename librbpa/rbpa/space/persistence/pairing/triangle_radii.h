// What: computes the radius at which each triangle of a Delaunay triangulation enters the full alpha complex.
// How:  the radius of the triangle's least sphere if no corner across from the triangle is inside, else the least
//       radius of a tetrahedron at the triangle; rounded up.
// Cost: linear; shared among threads.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994), section 4.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/persistence/pairing/number_faces.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// Returns the radius of each of `triangles`. Requires: `delaunay` is solid() of `points` at infinity, with neighbors;
/// `radii` are its circumradii(), and `triangles` its number_triangles().
std::vector<double> triangle_radii(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                                   const NumberedTriangles& triangles, Threads& threads, const GoOn& go_on);

}  // namespace rbpa::space

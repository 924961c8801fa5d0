// What: the radius at which each triangle of a Delaunay triangulation comes into the full alpha complex.
// How:  that of its own least sphere if no corner across is inside, else that of the first tetrahedron at it; rounded up.
// Cost: linear; shared among threads.
// Source: Edelsbrunner and Mücke, Three-dimensional alpha shapes (1994), section 4.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/solid.h"
#include "rbpa/space/persistence/number_faces.h"

namespace rbpa::space {

/// Requires: neighbors, the radii of the tetrahedra, and number_triangles() of them.
std::vector<double> triangle_radii(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii,
                                   const NumberedTriangles& triangles, Threads& threads,
                                   const std::function<bool()>& go_on);

}  // namespace rbpa::space

// What: checks the triangulation and radii that functions on the full alpha complex require.
#pragma once

#include <span>
#include <string>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// Checks that each tetrahedron has one radius and one row of neighbors, and all corners are below points.size().
/// Throws:   ContractViolation, with a message that begins with `function`.
void check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                         std::span<const double> radii);
/// Checks the triangulation and radii as check_triangulation() above does, and that alpha is above 0. Returns threads
/// suited to the number of points; a `threads` above 0 limits their number.
/// Throws: ContractViolation, with a message that begins with `function`; InvalidInput unless alpha is above 0.
Threads check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                            std::span<const double> radii, double alpha, unsigned threads);

}  // namespace rbpa::space

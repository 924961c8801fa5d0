// What: checks of the triangulation that functions on the full alpha complex require.
#pragma once

#include <span>
#include <string>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// Throws ContractViolation, with a message that begins with `function`, unless there is one radius and one row of
/// neighbors for each tetrahedron, and all corners are below points.size().
void check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                         std::span<const double> radii);
/// Checks the same, and alpha. Returns the threads for this number of points, at most `threads` if that is above 0.
/// Throws: ContractViolation as above; InvalidInput unless alpha is above 0.
Threads check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                            std::span<const double> radii, double alpha, unsigned threads);

}  // namespace rbpa::space

// What: checks of the triangulation that functions on the full alpha complex require.
#pragma once

#include <span>
#include <string>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"

namespace rbpa::space {

/// Throws: ContractViolation, whose message begins with the function's name, where radii or neighbors are missing or a
/// corner is not an index of a point.
void check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                         std::span<const double> radii);
/// Checks alpha too; returns the threads for that many points. Throws: as above; InvalidInput unless alpha is above 0.
Threads check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                            std::span<const double> radii, double alpha, unsigned threads);

}  // namespace rbpa::space

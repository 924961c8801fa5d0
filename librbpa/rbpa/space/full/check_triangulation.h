// What: what functions on the full alpha complex require of a triangulation.
#pragma once

#include <span>
#include <string>

#include "rbpa/base/parallel/threads.h"
#include "rbpa/base/point3.h"
#include "rbpa/solid.h"

namespace rbpa::space {

/// Throws: ContractViolation, which begins with the function's name, where radii or neighbors are missing, or a corner is none of the points.
void check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                         std::span<const double> radii);
/// Throws moreover: InvalidInput when alpha is no radius. Returns: threads for so many points.
Threads check_triangulation(const std::string& function, std::span<const Point3> points, const Solid& delaunay,
                            std::span<const double> radii, double alpha, unsigned threads);

}  // namespace rbpa::space

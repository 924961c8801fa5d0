// What: Delaunay tetrahedra of points in a cube that repeats, by CGAL's Periodic_3_Delaunay_triangulation_3.
// Law:  shares nothing with the library.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_test {

/// A corner: the point, and how many boxes it is away from where it was given.
using PeriodicCorner = std::array<int, 4>;

/// One of all images of each: corners ascending by points, the first in the box; sorted.
/// Requires: distinct points of the cube from 0 to `side`, the latter excluded, whose images one side away are doubles.
std::vector<std::array<PeriodicCorner, 4>> periodic_by_cgal(std::span<const rbpa::Point3> points, double side);

}  // namespace rbpa_test

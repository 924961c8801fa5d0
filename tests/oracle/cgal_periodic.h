// What: Delaunay tetrahedra of points in a cube that repeats, by CGAL's Periodic_3_Delaunay_triangulation_3.
// Law:  shares no code with the library.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_test {

/// Corner: the point, and the number of boxes along each axis from its given position.
using PeriodicCorner = std::array<int, 4>;

/// Returns one of all images of each tetrahedron: corners ascending by points, the first in the box; sorted.
/// Requires: distinct points of the cube from 0 to `side`, excluding `side`, whose images one side away are doubles.
std::vector<std::array<PeriodicCorner, 4>> periodic_by_cgal(std::span<const rbpa::Point3> points, double side);

}  // namespace rbpa_test

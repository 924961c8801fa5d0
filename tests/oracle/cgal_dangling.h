// What: triangles, edges and points of the full alpha complex that are faces of nothing in it, by CGAL's Alpha_shape_3.
// Law:  shares nothing with the library.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_test {

/// Ascending indices, sorted.
struct DanglingByCgal {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::uint32_t> points;
};

/// Requires: distinct points, not all in a plane; an alpha whose square is a double.
DanglingByCgal dangling_by_cgal(std::span<const rbpa::Point3> points, double alpha);

}  // namespace rbpa_test

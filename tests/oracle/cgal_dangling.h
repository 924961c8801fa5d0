// What: the dangling simplices of the full alpha complex, those that are faces of no other simplex of it, by CGAL's
//       Alpha_shape_3.
// Law:  shares no code with the library.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_test {

/// Dangling simplices: each with ascending indices, sorted.
struct DanglingByCgal {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::uint32_t> points;
};

/// Finds the dangling simplices. Requires: distinct points, not all in a plane; an alpha whose square is a double.
DanglingByCgal dangling_by_cgal(std::span<const rbpa::Point3> points, double alpha);

}  // namespace rbpa_test

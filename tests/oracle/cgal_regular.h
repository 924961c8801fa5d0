// What: the regular triangulation of balls in space by CGAL, in exact numbers.
// Law:  shares no code with the library.
#pragma once

#include <cstdint>
#include <vector>

#include "oracle/cgal_tetrahedra.h"
#include "support/ball_sets.h"

namespace rbpa_test {

/// The tetrahedra with neighbors as in TetrahedraByCgal; of balls in a plane, on a line or at a point the triangles,
/// edges or the vertex, as sorted rows, ascending, filled up with 0xffffffff; the distinct balls that are in none.
struct RegularByCgal {
  std::vector<Tetrahedron> simplices, neighbors, flat;
  std::vector<std::uint32_t> hidden;
};

RegularByCgal regular_by_cgal(const Balls& balls);

}  // namespace rbpa_test

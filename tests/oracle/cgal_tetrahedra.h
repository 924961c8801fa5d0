// What: the solid alpha complex of points in space by CGAL: its Delaunay triangulation, filtered by exact circumradii.
// Law:  shares nothing with the library.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_test {

using Tetrahedron = std::array<std::uint32_t, 4>;

/// Tetrahedra of the lowest indices at their corners, positively oriented, the two least corners first, sorted; and those across
/// from their corners, or 0xffffffff.
struct TetrahedraByCgal {
  std::vector<Tetrahedron> simplices, neighbors;
};

/// CGAL's Delaunay_triangulation_3 of the points: inserted once, filtered for as many alphas as asked for.
class DelaunayByCgal {
 public:
  explicit DelaunayByCgal(std::span<const rbpa::Point3> points);
  /// Those of circumradius at most alpha, in rational numbers. Requires: alpha above 0, or infinity.
  TetrahedraByCgal within(double alpha) const;

 private:
  std::vector<rbpa::Point3> points_;
  std::vector<Tetrahedron> cells_, neighbors_;
};

/// The two least corners first, by an even permutation; what is beside them goes with them.
void make_canonical(Tetrahedron& corners, Tetrahedron& beside);

}  // namespace rbpa_test

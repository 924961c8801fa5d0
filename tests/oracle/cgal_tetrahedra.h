// What: the solid alpha complex of points in space by CGAL: its Delaunay triangulation, filtered by exact circumradii.
// Law:  shares no code with the library.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa_test {

using Tetrahedron = std::array<std::uint32_t, 4>;

/// Tetrahedra, sorted: each with the lowest indices of its corners, positively oriented, the two lowest first; and the
/// tetrahedra across from their corners, or 0xffffffff.
struct TetrahedraByCgal {
  std::vector<Tetrahedron> simplices, neighbors;
};

/// CGAL's Delaunay_triangulation_3 of the points: built once, filtered for any number of alphas.
class DelaunayByCgal {
 public:
  explicit DelaunayByCgal(std::span<const rbpa::Point3> points);
  /// Returns the tetrahedra of circumradius at most alpha, in rational numbers. Requires: alpha above 0, or infinity.
  TetrahedraByCgal within(double alpha) const;

 private:
  std::vector<rbpa::Point3> points_;
  std::vector<Tetrahedron> cells_, neighbors_;
};

/// Puts the two corners of lowest index first, by an even permutation, and permutes `beside` in the same way.
void make_canonical(Tetrahedron& corners, Tetrahedron& beside);

}  // namespace rbpa_test

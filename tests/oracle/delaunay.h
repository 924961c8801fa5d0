// What: the solid alpha complex by CGAL: its Delaunay triangulation, filtered by exact circumradius.
// Law:  CGAL perturbs cocircular points by the same rule as the library, so the triangles are equal, not only similar.
// Cost: one triangulation in the constructor; one comparison per triangle and alpha.
#pragma once

#include <span>
#include <vector>

#include "support/triangle.h"

namespace rbpa_test {

/// Arithmetic in which CGAL decides.
enum class Kernel {
  filtered,  ///< Exact_predicates_inexact_constructions_kernel
  rational   ///< a kernel on rational numbers: slow, and right whatever the exponents
};

/// Returns `filtered`, unless an exponent is so large or small that a product of coordinates might leave the range of
/// double.
Kernel fitting_kernel(std::span<const rbpa::Point> points);

class DelaunayOracle {
 public:
  explicit DelaunayOracle(std::span<const rbpa::Point> points) : DelaunayOracle(points, fitting_kernel(points)) {}
  DelaunayOracle(std::span<const rbpa::Point> points, Kernel kernel);

  /// Returns canonical triangles of circumradius ≤ alpha; an index stands for the lowest index of a point equal to it.
  std::vector<Triangle> triangles(double alpha) const;

 private:
  Points points_;
  std::vector<Triangle> delaunay_;
};

}  // namespace rbpa_test

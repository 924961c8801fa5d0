// What: computes the solid alpha complex directly from its definition, for tiny sets.
// How:  tests every triple against every other point; the in-circle determinant with the lift x² + y² + ε(p) is
//       expanded in the infinitesimals, in exact arithmetic. Shares no code with the library and none with CGAL.
// Cost: n⁴ determinants.
#pragma once

#include <span>
#include <vector>

#include "support/triangle.h"

namespace rbpa_test {

/// Returns canonical triangles; an index stands for the lowest index of a point equal to it.
std::vector<Triangle> brute_force(std::span<const rbpa::Point> points, double alpha);

/// Computes the triangles always in rational numbers (brute_force() uses 128-bit integers for small integer
/// coordinates).
std::vector<Triangle> brute_force_in_rationals(std::span<const rbpa::Point> points, double alpha);

}  // namespace rbpa_test

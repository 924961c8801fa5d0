// What: computes circumradii of tetrahedra, rounded up to doubles.
// Law:  a result is the least double that is not below the circumradius, for any finite points that are not in a plane;
//       infinity for a circumradius above all doubles.
// How:  double-double for several radii at a time; integers of any length where double-double does not decide, as for
//       radii that are exact doubles.
// Cost: some tens of nanoseconds a radius; some ten microseconds by integers.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Sets radii[i] to the rounded-up radius of simplices[i]. Requires: corners are indices of `points`; no simplex is in
/// a plane; `radii` has one element for each simplex.
void circumradii_rounded_up(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 4>> simplices,
                            std::span<double> radii);

/// Returns the rounded-up circumradius of a, b, c and d by integers.
double circumradius_rounded_up(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

}  // namespace rbpa::space

// What: circumradii of four points, rounded up to doubles.
// Law:  the least double that is not below it, for any finite points that are in no plane; infinity above all doubles.
// How:  double-double, several at a time; integers of any length where two doubles are left, as for radii that are doubles.
// Cost: some tens of nanoseconds each; some ten microseconds by integers.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Of each simplex, in its place. Requires: corners that are points, as many radii.
void circumradii_rounded_up(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 4>> simplices,
                            std::span<double> radii);

/// By integers.
double circumradius_rounded_up(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

}  // namespace rbpa::space

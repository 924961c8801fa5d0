// What: the power of two by which points of space and a radius fit double, so that filters need not think of underflow and
//       overflow (predicate/magnitude.h).
#pragma once

#include <optional>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// The exponent of a power of two by which coordinates and radius, multiplied exactly, fit double: fits_double() holds for
/// the coordinates, and the radius is between 2^-150 and 2^150. It is 0 where that is so already. Nothing when there is none.
/// Requires: finite points, a finite radius above 0. Cost: linear.
std::optional<int> scale_to_double(std::span<const Point3> points, double radius);

}  // namespace rbpa::space

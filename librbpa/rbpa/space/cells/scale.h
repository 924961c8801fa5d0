// What: finds a power of two that scales points in space and a radius so that no product in a filter underflows or
//       overflows (base/exact/magnitude.h).
#pragma once

#include <optional>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Returns the exponent of a power of two by which coordinates and radius can be multiplied exactly so that they fit
/// double: fits_double() holds for the coordinates, and the radius is between 2^-150 and 2^150. Returns 0 if
/// coordinates and radius fit unscaled, and nothing if no power makes them fit.
/// Requires: finite points, a finite radius above 0. Cost: linear.
std::optional<int> scale_to_double(std::span<const Point3> points, double radius);

}  // namespace rbpa::space

// What: tests whether points lie on one line; the complex of such points is empty for every alpha.
#pragma once

#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"

namespace rbpa {

/// Returns whether all points lie on one line, exactly; true for fewer than three distinct points.
/// Requires: finite points.
/// Cost:     linear; stops at the first point off the line.
RBPA_API bool are_collinear(std::span<const Point> points);

}  // namespace rbpa

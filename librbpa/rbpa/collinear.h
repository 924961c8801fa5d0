// What: do points lie on one line? Then their complex is empty for every alpha.
#pragma once

#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"

namespace rbpa {

/// All points lie on one line; also when there are fewer than three distinct ones. Exact.
/// Requires: finite points.
/// Cost:     linear; stops at the first point off the line.
RBPA_API bool are_collinear(std::span<const Point> points);

}  // namespace rbpa

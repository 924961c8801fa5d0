// What: a polygon for tests of filling, and the message with which polygons are refused.
#pragma once

#include <string>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/fill.h"
#include "support/refusal_of.h"
#include "support/triangle.h"

namespace rbpa_test {

/// Returns a square of the first four points.
inline rbpa::Polygon square() { return {.shell = {{0, 1, 2, 3}}}; }

/// Returns the message of the refusal; "" when the polygons are filled.
inline std::string refusal(const Points& points, const std::vector<rbpa::Polygon>& polygons,
                           const rbpa::FillOptions& options = {.size = 1}) {
  return refusal_of<rbpa::InvalidInput>([&] { rbpa::fill(points, polygons, options); });
}

}  // namespace rbpa_test

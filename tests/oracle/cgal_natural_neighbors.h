// What: natural neighbor coordinates by CGAL, on exact numbers.
#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "rbpa/base/point.h"

namespace rbpa_test {

/// Returns the share of each point at a query, which must be inside the convex hull of distinct points.
std::map<std::uint32_t, double> natural_neighbor_coordinates(std::span<const rbpa::Point> points,
                                                             const rbpa::Point& query);

}  // namespace rbpa_test

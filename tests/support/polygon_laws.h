// What: checks every law of the polygons of a complex except their position in the plane.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rbpa/plane/outline_polygons.h"
#include "rbpa/rbpa.h"
#include "support/triangle.h"

namespace rbpa_test {

/// Returns the first broken law of polygons that were not filtered, "" when there is none. A law is broken when
///   a ring is too short, passes a point twice, does not begin with its lexicographically least point; rings or
///   polygons are out of order; a boundary edge of the triangles is not on one ring, in its direction, or a ring has
///   another edge; a polygon is not the boundary of one solid component, or has not one hole for each of that
///   component's.
std::string wrong_with_polygons(const std::vector<rbpa::Polygon>& polygons, const std::vector<Triangle>& triangles,
                                std::span<const rbpa::Point> points);

/// Returns the points of every ring, shell first, polygon by polygon.
std::vector<std::vector<Points>> coordinates_of(const std::vector<rbpa::Polygon>& polygons,
                                                std::span<const rbpa::Point> points);

/// Returns twice the area, exactly. Requires: the points are integers below 2²⁶ in size.
long long twice_area(const std::vector<Triangle>& triangles, std::span<const rbpa::Point> points);

}  // namespace rbpa_test

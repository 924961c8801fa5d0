// What: adds points far away to points in a plane, so that they have a triangulation in space.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "rbpa/base/error.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/predicate/bounding_box.h"

namespace rbpa::space {

/// Returns the points and three additional ones, whose plane contains no point, and which are farther away than twice
/// the radius. Requires: at least one point. Throws: InvalidInput if the additional points would not be finite.
inline std::vector<Point3> with_far_points(std::span<const Point3> points, double radius) {
  const auto [low, high] = box_of(points);
  double far = 4 * (radius + (high.x - low.x) + (high.y - low.y) + (high.z - low.z));
  for (const double coordinate : {high.x, high.y, high.z}) far = std::max(far, 0x1p-40 * std::abs(coordinate));
  if (far == 0) far = 1;
  std::vector<Point3> all(points.begin(), points.end());
  for (const Point3& p : {Point3{high.x + far, high.y, high.z}, Point3{high.x, high.y + far, high.z},
                          Point3{high.x, high.y, high.z + far}}) {
    if (!is_finite(p))
      throw InvalidInput(
          "all points are in a plane, and points farther away than all balls would not be finite, expected points "
          "nearer "
          "together or a smaller radius");
    all.push_back(p);
  }
  return all;
}

}  // namespace rbpa::space

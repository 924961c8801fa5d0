// What: checks the input of functions on points in space.
// Cost: linear.
#pragma once

#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

// Each of the following functions throws InvalidInput that names the first violated requirement.

/// Checks that points are fewer than 2^32 − 1, and all finite.
void check_points(std::span<const Point3> points);
/// Checks the centers by check_points(), and that there is one radius for each center. Does not check the values.
void check_centers(std::span<const Point3> centers, std::span<const double> radii);
/// Checks centers and radii by check_centers(), and that all radii are finite and at least 0.
void check_balls(std::span<const Point3> centers, std::span<const double> radii);
/// Checks that 0 < radius < infinity.
void check_radius(double radius);
/// Checks that there is at least one radius, and that radii are strictly ascending, above 0 and finite.
void check_radii(std::span<const double> radii);
/// Checks that there is one normal for each point, and that normals are finite and not 0.
void check_normals(std::span<const Point3> points, std::span<const Point3> normals);

}  // namespace rbpa::space

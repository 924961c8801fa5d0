// What: input checks shared by all functions on points in space.
// Cost: linear.
#pragma once

#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

// Each function throws InvalidInput that names the first violated requirement.

/// Checks that all points are finite, and fewer than 2^32 − 1.
void check_points(std::span<const Point3> points);
/// Checks the centers by check_points(), and that there is one radius for each. Does not check the values of radii.
void check_centers(std::span<const Point3> centers, std::span<const double> radii);
/// Checks as check_centers() does, and that radii are finite and at least 0.
void check_balls(std::span<const Point3> centers, std::span<const double> radii);
/// Checks that 0 < radius < infinity.
void check_radius(double radius);
/// Checks that there is at least one radius, and that radii are strictly ascending, above 0 and finite.
void check_radii(std::span<const double> radii);
/// Checks that there is one normal for each point, and that normals are finite and not 0.
void check_normals(std::span<const Point3> points, std::span<const Point3> normals);

}  // namespace rbpa::space

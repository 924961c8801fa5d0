// What: input checks shared by all functions on points in space.
// Cost: linear.
#pragma once

#include <span>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Throws InvalidInput, which names the violated requirement; so do the functions below.
/// Requires: finite points, fewer than 2^32 − 1.
void check_points(std::span<const Point3> points);
/// Requires: as check_points(); one radius for each center. The values of radii are not checked.
void check_centers(std::span<const Point3> centers, std::span<const double> radii);
/// Requires: 0 < radius < infinity.
void check_radius(double radius);
/// Requires: at least one radius, 0 < radius < infinity, strictly ascending.
void check_radii(std::span<const double> radii);
/// Requires: one normal for each point, finite, of any length but 0.
void check_normals(std::span<const Point3> points, std::span<const Point3> normals);

}  // namespace rbpa::space

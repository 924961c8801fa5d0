// What: the least sphere through two or three points: its radius, and which points are inside.
// Law:  exact for every finite input. A point on the sphere is not inside.
// How:  a filter in long double (docs/predicates.md, section 7), then integers of any length.
// Cost: some ten nanoseconds; microseconds where the filter fails.
#pragma once

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// Requires: distinct points, three of them on no line; a finite radius.
bool is_least_sphere_within(const Point3& a, const Point3& b, double radius);
bool is_least_sphere_within(const Point3& a, const Point3& b, const Point3& c, double radius);

/// The radius rounded up: the least double that is not below it; infinity above all doubles.
/// Requires: distinct points, three of them on no line.
double least_radius_rounded_up(const Point3& a, const Point3& b);
double least_radius_rounded_up(const Point3& a, const Point3& b, const Point3& c);

/// Whether q is inside.
bool in_least_sphere(const Point3& a, const Point3& b, const Point3& q);
bool in_least_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& q);

}  // namespace rbpa::space

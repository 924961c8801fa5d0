// What: computes the signs of geometric predicates in space by integers of any length, as their last stage.
// Law:  exact for all finite doubles.
// Cost: microseconds; more for a greater range of exponents.
#pragma once

#include <array>

#include "rbpa/base/point3.h"

namespace rbpa::space::exact {

/// Returns the sign of (b − a) × (c − a) · (d − a): 1 when a, b, c are counter-clockwise seen from d.
int orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Returns the sign of (distance of o and a) − (distance of o and b).
int compare_distances(const Point3& o, const Point3& a, const Point3& b);

/// Returns the sign of (half the distance of a and b) − radius.
int compare_circumradius(const Point3& a, const Point3& b, double radius);

/// Returns the sign of (circumradius of (a, b, c)) − radius. The circumradius of points on a line is infinite.
int compare_circumradius(const Point3& a, const Point3& b, const Point3& c, double radius);

/// Returns the sign of (circumradius of (a, b, c, d)) − radius. The circumradius of points in a plane is infinite.
int compare_circumradius(const Point3& a, const Point3& b, const Point3& c, const Point3& d, double radius);

/// Returns the side of the sphere through a, b, c, d on which q is: 1 inside, −1 outside, 0 on the sphere. With
/// `radii`, of a, b, c, d and q in this order, the points are centers of balls. The sphere is then orthogonal to the
/// first four balls, and q is inside if the power of q to the sphere, minus the square of the radius of q, is negative.
/// Requires: orientation(a, b, c, d) > 0.
int side_of_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& q,
                   const std::array<double, 5>* radii = nullptr);

/// Returns 1 if q is inside the least sphere through a and b, or a, b and c; −1 if q is outside, 0 if q is on it.
/// Requires: a and b are distinct; a, b and c are on no line.
int side_of_least_sphere(const Point3& a, const Point3& b, const Point3& q);
int side_of_least_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& q);

/// Returns the side on which q is of the ball with this radius that touches a, b, c and has its center on the side from
/// which they are counter-clockwise: 1 inside, −1 outside, 0 if q touches the ball, too.
/// Requires: the circumradius of (a, b, c) is at most the radius.
int side_of_ball(const Point3& a, const Point3& b, const Point3& c, double radius, const Point3& q);

/// Returns the sign of (b − a) × (c − a) · normal.
int normal_sign(const Point3& a, const Point3& b, const Point3& c, const Point3& normal);

/// Returns the sign of (b − a) × (c − a) · (e − d) × (f − d).
int compare_normals(const Point3& a, const Point3& b, const Point3& c, const Point3& d, const Point3& e,
                    const Point3& f);

}  // namespace rbpa::space::exact

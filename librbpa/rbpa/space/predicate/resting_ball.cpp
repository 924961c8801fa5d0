#include "rbpa/space/predicate/resting_ball.h"

namespace rbpa::space {
namespace {

/// Returns whether the perturbation moves q into the circle of (a, b, c). Requires: q is on the circle. The
/// lexicographically largest of the four points is lifted most (docs/explanation/exact_decisions.md, section 2). If q
/// is the largest, q leaves the circle. If a corner is the largest, q moves inside if q and the corner are on one side
/// of the line through the other two corners.
bool pulled_in(const Point3& a, const Point3& b, const Point3& c, const Point3& q) {
  if (a < q && b < q && c < q) return false;
  if (b < a && c < a) return exact::compare_normals(q, b, c, a, b, c) > 0;
  return c < b ? exact::compare_normals(a, q, c, a, b, c) > 0 : exact::compare_normals(a, b, q, a, b, c) > 0;
}

}  // namespace

bool in_ball_exactly(const Point3& a, const Point3& b, const Point3& c, double radius, const Point3& q) {
  if (const int side = exact::side_of_ball(a, b, c, radius, q); side != 0) return side > 0;
  // q touches the ball. As a resting ball grows, points of its boundary above the plane of the three points move
  // inside, and points below leave.
  if (const int above = exact::orientation(a, b, c, q); above != 0) return above > 0;
  return pulled_in(a, b, c, q);
}

}  // namespace rbpa::space

#include "rbpa/space/predicate/ball.h"

namespace rbpa::space {
namespace {

/// q is on the circle of (a, b, c): inside where the perturbation puts it. The lexicographically largest of the four is
/// lifted most (docs/predicates.md, section 2): q leaves the circle; a corner pulls in what is on its side.
bool pulled_in(const Point3& a, const Point3& b, const Point3& c, const Point3& q) {
  if (a < q && b < q && c < q) return false;
  if (b < a && c < a) return exact::compare_normals(q, b, c, a, b, c) > 0;
  return c < b ? exact::compare_normals(a, q, c, a, b, c) > 0 : exact::compare_normals(a, b, q, a, b, c) > 0;
}

}  // namespace

bool in_ball_exactly(const Point3& a, const Point3& b, const Point3& c, double radius, const Point3& q) {
  if (const int side = exact::side_of_ball(a, b, c, radius, q); side != 0) return side > 0;
  // It touches too. A ball that grows while it rests on the three swallows what is above their plane, and leaves what is
  // below.
  if (const int above = exact::orientation(a, b, c, q); above != 0) return above > 0;
  return pulled_in(a, b, c, q);
}

}  // namespace rbpa::space

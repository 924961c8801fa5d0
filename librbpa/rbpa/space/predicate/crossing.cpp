#include "rbpa/space/predicate/crossing.h"

#include <algorithm>
#include <cstddef>

#include "rbpa/space/predicate/orientation.h"

namespace rbpa::space {
namespace {

int side_of(const Corners& t, const Point3& p) { return orientation(t[0], t[1], t[2], p); }

bool has(const Corners& t, const Point3& p) { return p == t[0] || p == t[1] || p == t[2]; }

/// Tests of points in the plane of a triangle, projected along an axis that is not parallel to the plane.
class InPlane {
 public:
  /// Keeps a reference to t. Requires: t has an area.
  explicit InPlane(const Corners& t) : t_(t) {
    while (axis_ < 2 && turn(t[0], t[1], t[2]) == 0) ++axis_;
  }

  int turn(const Point3& a, const Point3& b, const Point3& c) const { return orientation_along(a, b, c, axis_); }
  bool holds(const Point3& p) const {
    const int first = turn(t_[0], t_[1], p), second = turn(t_[1], t_[2], p), third = turn(t_[2], t_[0], p);
    return (first >= 0 && second >= 0 && third >= 0) || (first <= 0 && second <= 0 && third <= 0);
  }
  bool meet(const Point3& p, const Point3& q, const Point3& a, const Point3& b) const {
    const int to_p = turn(a, b, p), to_q = turn(a, b, q), to_a = turn(p, q, a), to_b = turn(p, q, b);
    if (to_p * to_q > 0 || to_a * to_b > 0) return false;
    if (to_p != 0 || to_q != 0 || to_a != 0 || to_b != 0) return true;
    return std::max(std::min(p, q), std::min(a, b)) <= std::min(std::max(p, q), std::max(a, b));  // on one line
  }
  bool meets(const Point3& p, const Point3& q) const {
    return holds(p) || meet(p, q, t_[0], t_[1]) || meet(p, q, t_[1], t_[2]) || meet(p, q, t_[2], t_[0]);
  }

 private:
  const Corners& t_;
  int axis_ = 0;
};

/// Returns whether the segment pq and the triangle t have a point in common. `side_p` and `side_q` are the sides of the
/// triangle's plane on which p and q are.
bool meets(const Point3& p, int side_p, const Point3& q, int side_q, const Corners& t) {
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return InPlane(t).meets(p, q);
  const int first = orientation(p, q, t[0], t[1]), second = orientation(p, q, t[1], t[2]);
  if (first * second < 0) return false;
  const int third = orientation(p, q, t[2], t[0]);
  return first * third >= 0 && second * third >= 0;
}

bool cross_at_side(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  if (orientation(a, b, c, d) != 0) return false;
  const Corners t = {a, b, c};
  const InPlane plane(t);
  return plane.turn(a, b, c) == plane.turn(a, b, d);
}

/// Returns whether s and t, whose common corner v is s[0] and t[0], cross. Crossing triangles intersect in a segment
/// from v to the side across from v of one of them.
bool cross_at_corner(const Corners& s, const Corners& t) {
  const int side_c = side_of(s, t[1]), side_d = side_of(s, t[2]);
  if (side_c * side_d > 0) return false;
  const int side_a = side_of(t, s[1]), side_b = side_of(t, s[2]);
  if (side_a * side_b > 0) return false;
  return meets(s[1], side_a, s[2], side_b, t) || meets(t[1], side_c, t[2], side_d, s);
}

/// Sets `sides` to the sides of the plane of t on which the corners of s are. Returns false if all are strictly on one
/// side.
bool straddles(const Corners& s, const Corners& t, std::array<int, 3>& sides) {
  for (std::size_t k = 0; k < 3; ++k) sides[k] = side_of(t, s[k]);
  return sides[0] * sides[1] <= 0 || sides[1] * sides[2] <= 0;
}

bool cross_apart(const Corners& s, const Corners& t) {
  std::array<int, 3> of_s{}, of_t{};
  if (!straddles(s, t, of_s) || !straddles(t, s, of_t)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (meets(s[k], of_s[k], s[next], of_s[next], t) || meets(t[k], of_t[k], t[next], of_t[next], s)) return true;
  }
  return false;
}

}  // namespace

bool triangles_cross(const Corners& s, const Corners& t) {
  std::array<std::size_t, 3> common_s{}, common_t{};
  std::size_t common = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      if (s[i] != t[j]) continue;
      common_s[common] = i;
      common_t[common] = j;
      ++common;
    }
  if (common == 0) return cross_apart(s, t);
  if (common == 3) return true;
  const std::size_t i = common_s[0], j = common_t[0];
  if (common == 1)
    return cross_at_corner({s[i], s[(i + 1) % 3], s[(i + 2) % 3]}, {t[j], t[(j + 1) % 3], t[(j + 2) % 3]});
  return cross_at_side(s[i], s[common_s[1]], s[3 - i - common_s[1]], t[3 - j - common_t[1]]);
}

bool segment_crosses(const Point3& p, const Point3& q, const Corners& t) {
  const bool has_p = has(t, p), has_q = has(t, q);
  if (has_p && has_q) return true;
  if (!has_p && !has_q) return meets(p, side_of(t, p), q, side_of(t, q), t);
  const Point3 &corner = has_p ? p : q, &end = has_p ? q : p;
  if (side_of(t, end) != 0) return false;
  const InPlane plane(t);
  const std::size_t at = t[0] == corner ? 0 : t[1] == corner ? 1 : 2;
  return plane.holds(end) || plane.meet(corner, end, t[(at + 1) % 3], t[(at + 2) % 3]);
}

}  // namespace rbpa::space

#include "rbpa/space/surface/pivot/roll_about_edge.h"

namespace rbpa::space {

template <typename Real>
std::size_t EdgeRoll<Real>::holder(const RestingBall<Real>& ball, std::size_t p) const {
  for (std::size_t q = 0; q < points_.size(); ++q)
    if (q != p && q != b_ && ball.contains(points_[q])) return q;
  return none;
}

// An interval of the circle, on which the ball contains a point, begins where the ball leaves `start`, and ends where
// it leaves `end`. The interval is extended to where the ball leaves the next point that it contains, until the ball
// contains none, or the interval is the whole circle.
template <typename Real>
std::size_t EdgeRoll<Real>::first_left_free() const {
  std::size_t start = 0;
  RestingBall<Real> beginning;
  for (; start < points_.size(); ++start) {
    if (start == b_) continue;
    beginning = leaving(start);
    if (beginning.rests()) break;
  }
  if (start == points_.size()) return none;

  std::size_t end = start;
  RestingBall<Real> ball = beginning;
  std::size_t reach = none;  // the point that the ball leaves last among those found in the ball at the beginning
  while (true) {
    const std::size_t q = holder(ball, end);
    if (q == none) return end;
    // q is in the ball up to the beginning or beyond, so it is in the ball all around
    if (q == start || q == reach) return none;
    const RestingBall<Real> next = leaving(q);
    if (!next.rests()) return none;  // q is in the ball all around
    if (beginning.contains(points_[q])) {
      // Either q is in the ball from the beginning past the end, farther than `reach`; or q is in the ball from the end
      // past the beginning, so that the ball contains q, or one of q and `reach`, all around.
      if (reach != none && next.contains(points_[reach])) return none;
      reach = q;
    }
    end = q;
    ball = next;
  }
}

template <typename Real>
std::size_t EdgeRoll<Real>::next_left_free(std::size_t from) const {
  while (true) {
    const std::size_t q = holder(leaving(from), from);
    if (q == none) return from;
    from = q;
  }
}

// The point `left` itself is touched last, after a full turn of the ball.
template <typename Real>
std::size_t EdgeRoll<Real>::first_touched(std::size_t left) const {
  const Point3& c = points_[left];
  const RestingBall<Real> start = leaving(left);
  std::size_t best = left;
  RestingBall<Real> at_best = coming_to(left);
  int c_after_best = 0;  // the side of c in a turn that begins at `best`
  for (std::size_t p = 0; p < points_.size(); ++p) {
    if (p == left || p == best || p == b_) continue;
    RestingBall<Real> at_p;
    if (at_best.contains(points_[p])) {
      at_p = coming_to(p);
    } else {
      // p is touched earlier only if the ball leaves p before it touches `best`: the middle of p's arc is then in
      // between.
      if (best != left) {
        const int turns =
            (start.side_of_plane(points_[p]) > 0) + (at_best.side_of_plane(points_[p]) > 0) + c_after_best;
        if (turns < 2) continue;
      }
      at_p = coming_to(p);
      if (!at_p.rests() || at_p.contains(c) || (best != left && at_p.contains(points_[best]))) continue;
    }
    best = p;
    at_best = at_p;
    c_after_best = start.side_of_plane(points_[best]) < 0;
  }
  return best;
}

template class EdgeRoll<double>;
template class EdgeRoll<long double>;

}  // namespace rbpa::space

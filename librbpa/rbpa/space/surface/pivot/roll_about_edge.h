// What:   rolls the ball all the way around an edge, and finds the arcs on which the ball contains no point, and the
//         triangles at the ends of these arcs. rolling_ball.h rolls one step.
// Law:    exact. Each free arc of the circle of the ball's centers is reported once, with the exposed triangles at its
//         beginning and at its end. A function of the edge and the set of points. docs/explanation/surfaces.md, section
//         12.
// How:    if the ball contains another point where it leaves one, the search continues where it leaves that other
//         point. If the ball contains none, it is free until it touches the next point.
// Cost:   two passes over all points for each free arc. Most edges have no free arc, which is found by testing a few
//         balls against points until each contains one.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/space/predicate/resting_ball.h"

namespace rbpa::space {

template <typename Real>
class EdgeRoll {
 public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// Prepares to roll a ball of the radius about the edge from a to points[b]. Keeps the span. Requires: `points` are
  /// distinct, do not include a, and include all points that the ball can touch or contain. The search is faster if
  /// near points come first.
  EdgeRoll(const Point3& a, std::size_t b, double radius, std::span<const Point3> points)
      : a_(a), b_(b), radius_(radius), points_(points) {}

  /// Calls visit(c, p) for each free arc, with positions among the points: the ball rolls from the exposed triangle (a,
  /// b, c) to the exposed triangle (b, a, p). The two may have the same three corners.
  template <typename Visit>
  void for_each_free_arc(Visit visit) {
    const std::size_t first = first_left_free();
    if (first == none) return;
    std::size_t left = first;
    do {
      const std::size_t touched = first_touched(left);
      visit(left, touched);
      left = next_left_free(touched);
    } while (left != first);
  }

 private:
  /// Returns the ball as it leaves p: it rests on (a, b, p). coming_to() returns the ball coming to p, on (b, a, p).
  RestingBall<Real> leaving(std::size_t p) const { return RestingBall<Real>(a_, points_[b_], points_[p], radius_); }
  RestingBall<Real> coming_to(std::size_t p) const { return RestingBall<Real>(points_[b_], a_, points_[p], radius_); }

  /// Returns the least position of a point that lies in the ball, other than p and b; `none` if there is no such
  /// point. Requires: the ball rests on p.
  std::size_t holder(const RestingBall<Real>& ball, std::size_t p) const;
  /// Returns the position of a point that the ball leaves into a free arc, or none if there is no free arc.
  std::size_t first_left_free() const;
  /// Returns the first position from `from` on, as above. Requires: the ball has come to `from`; there is a free arc.
  std::size_t next_left_free(std::size_t from) const;
  /// Returns the position of the point touched first after the ball has left `left`. Requires: the ball is free there.
  std::size_t first_touched(std::size_t left) const;

  Point3 a_;
  std::size_t b_;
  double radius_;
  std::span<const Point3> points_;
};

extern template class EdgeRoll<double>;
extern template class EdgeRoll<long double>;

}  // namespace rbpa::space

// What:   the ball rolls all the way around an edge: on which arcs it holds no point, and on which triangles they end.
// Law:    exact. Each free arc of the circle of its centers is reported once, by the exposed triangle at which it begins and
//         the one at which it ends. A function of the edge and the set of points. docs/surface_derivation.md, section 4.
// How:    where the ball leaves a point, another one may hold it: then go on to where it leaves that one. Where none does, the
//         ball is free until it touches the first point.
// Cost:   at most edges no arc is free, which takes a few balls, each tested against points until one is in it; each free arc
//         takes two passes over all points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "rbpa/space/predicate/ball.h"

namespace rbpa::space {

template <typename Real>
class EdgeRoll {
 public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// A ball of the radius about the edge from a to points[b].
  /// Requires: distinct points, a none of them; all that any such ball can touch or hold. It is faster when near points come
  /// first.
  EdgeRoll(const Point3& a, std::size_t b, double radius, std::span<const Point3> points)
      : a_(a), b_(b), radius_(radius), points_(points) {}

  /// Calls visit(c, p) for each free arc, with positions among the points: the ball rolls from the exposed triangle (a, b, c)
  /// to the exposed triangle (b, a, p). They may have the same three corners.
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
  /// Where the ball leaves p, it rests on (a, b, p); where it comes to p, on (b, a, p).
  Ball<Real> leaving(std::size_t p) const { return Ball<Real>(a_, points_[b_], points_[p], radius_); }
  Ball<Real> coming_to(std::size_t p) const { return Ball<Real>(points_[b_], a_, points_[p], radius_); }

  /// The first point in the ball, or none. Requires: the ball rests on p.
  std::size_t holder(const Ball<Real>& ball, std::size_t p) const;
  /// A point after which the ball is free, where it leaves it; none when there is none.
  std::size_t first_left_free() const;
  /// The first such point after the ball has come to `from`. Requires: there is one.
  std::size_t next_left_free(std::size_t from) const;
  /// The point that the ball touches first after it has left `left`. Requires: it is free there.
  std::size_t first_touched(std::size_t left) const;

  Point3 a_;
  std::size_t b_;
  double radius_;
  std::span<const Point3> points_;
};

extern template class EdgeRoll<double>;
extern template class EdgeRoll<long double>;

}  // namespace rbpa::space

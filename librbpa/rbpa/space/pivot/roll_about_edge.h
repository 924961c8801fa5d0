// What:   the ball rolls all the way around an edge: where it is free to be, and on which triangles it comes to rest.
// Law:    exact. Each free arc of the circle of its centres is reported once: the exposed triangle that it leaves and the one
//         that it comes to. The answer is a function of the edge and the set of points. docs/surface_derivation.md, section 4.
// How:    where the ball leaves a point, whatever holds it there carries it on; where nothing does, it is free until it
//         touches the first point.
// Cost:   a few balls where no arc is free, which is where most edges end, each asked about points until one is in it; for
//         each free arc, two looks at all points.
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

  /// A ball of the radius about the edge from a to points[b]. The points are distinct, a is none of them, and they are all that
  /// any such ball can touch or hold; those near to the edge had better come first.
  EdgeRoll(const Point3& a, std::size_t b, double radius, std::span<const Point3> points)
      : a_(a), b_(b), radius_(radius), points_(points) {}

  /// Calls visit(c, p) for each free arc, with positions among the points: the ball leaves the exposed triangle (a, b, c),
  /// and comes to the exposed triangle (b, a, p). They may be of the same three points.
  template <typename Visit>
  void for_each_free_arc(Visit visit) {
    const std::size_t first = first_left_free();
    if (first == none) return;
    std::size_t left = first;
    do {
      const std::size_t touched = first_touched(left);
      visit(left, touched);
      left = carried_on(touched);
    } while (left != first);
  }

 private:
  /// Where the ball leaves p, it is on (a, b, p); where it comes to p, on (b, a, p).
  Ball<Real> leaving(std::size_t p) const { return Ball<Real>(a_, points_[b_], points_[p], radius_); }
  Ball<Real> coming_to(std::size_t p) const { return Ball<Real>(points_[b_], a_, points_[p], radius_); }

  /// The first point in the ball, or none; p, at which it rests, is not.
  std::size_t holder(const Ball<Real>& ball, std::size_t p) const;
  /// A point that the ball leaves without being held by another; none when there is none.
  std::size_t first_left_free() const;
  /// The same, the first after it has come to `from`. Requires that there is one.
  std::size_t carried_on(std::size_t from) const;
  /// What the ball touches first after it has left `left`, where it is free.
  std::size_t first_touched(std::size_t left) const;

  Point3 a_;
  std::size_t b_;
  double radius_;
  std::span<const Point3> points_;
};

extern template class EdgeRoll<double>;
extern template class EdgeRoll<long double>;

}  // namespace rbpa::space

// What:   the ball of radius α among points of the plane, which pivots on an edge and rolls around a point.
// Law:    all decisions are exact. The results depend on the set of points alone, not on the order of points or on a
//         mesh; but of several nearest points, nearest() returns any.
// Cost:   each call reads V_p, the points in nine cells of side 2α.
// Source: Restricted BPA, sections 3.1, "Geometric step", and 3.2; rolling: docs/explanation/paper.md, section 3.
#pragma once

#include <optional>
#include <span>

#include "rbpa/paper/grid.h"

namespace rbpa::paper {

class Ball {
 public:
  /// Makes a ball that touches only `sites`, which are indices into `points`. Keeps the span `points`. Requires: the
  /// points are distinct.
  Ball(std::span<const Point> points, std::span<const Site> sites, Radius alpha)
      : points_(points), alpha_(alpha), grid_(points, sites, alpha) {}

  const Radius& alpha() const { return alpha_; }

  /// Returns the point that the ball touches first when it pivots on the Delaunay edge a→b, to the left of the edge:
  /// the point that sees the edge under the largest angle (figure 3); symbolic perturbation decides ties. Returns
  /// nothing if no point is left of the edge, or if the circumradius of the triangle is above α.
  /// Requires: a→b is a Delaunay edge of the sites; |ab| ≤ 2α.
  std::optional<Site> pivot(Site a, Site b) const;

  /// Returns a nearest point to v, other than v; nothing if its distance is above 2α, so that the ball cannot touch
  /// both points.
  std::optional<Site> nearest(Site v) const;

  /// Returns the point on which the ball rests next when it rolls counter-clockwise around v off the point `from`. If
  /// the ball meets no other point in a full turn, returns `from`. Of several points that the ball touches
  /// simultaneously, returns the first counter-clockwise around v.
  /// Requires: α is finite; the ball that rests on v and `from` with its center left of v→from contains no point and
  ///           touches no other.
  Site roll(Site v, Site from) const;

 private:
  using P = Predicates<Real>;

  const Point& at(Site s) const { return points_[s]; }
  bool met_before(Site v, Site from, Site q, Site p) const;
  bool in_arriving_ball(Site v, Site p, Site q) const;

  std::span<const Point> points_;
  Radius alpha_;
  Grid grid_;
};

}  // namespace rbpa::paper

// What:   the ball of radius α among points of the plane: it pivots on an edge, and it rolls around a point.
// Law:    exact; each answer is a function of the points alone, of no order of theirs and of no mesh.
// Cost:   one look at V_p, the points in nine cells of side 2α.
// Source: Restricted BPA, section 3.1, "Geometric step", and section 3.2; rolling: docs/seeding.md.
#pragma once

#include <optional>
#include <span>

#include "rbpa/paper/grid.h"

namespace rbpa::paper {

class Ball {
 public:
  /// The ball sees the given sites and no others. Refers to the points, which are distinct.
  Ball(std::span<const Point> points, std::span<const Site> sites, Radius alpha)
      : points_(points), alpha_(alpha), grid_(points, sites, alpha) {}

  const Radius& alpha() const { return alpha_; }

  /// Pivots on the Delaunay edge a→b, to its left, until it touches a point: the one that sees the edge under the largest
  /// angle (figure 3), ties perturbed. Nothing when there is none, or only beyond the ball: R > α.
  /// Requires: |ab| ≤ 2α.
  std::optional<Site> pivot(Site a, Site b) const;

  /// The nearest other point, of several any, unless the ball cannot touch both: farther than 2α.
  std::optional<Site> nearest(Site v) const;

  /// Rolls counter-clockwise around v off the point `from`, and comes to rest on the next: `from` when it is back there.
  /// Of points that it comes to at once, the first counter-clockwise around v.
  /// Requires: a finite radius; at the start, resting on v and `from` with its center left of v→from, the ball is empty and
  ///           touches no other point.
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

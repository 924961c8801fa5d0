// What:   the ball of radius α among points of the plane: it pivots on an edge, and it rolls around a point.
// Law:    exact; each answer is a function of the set of points alone, not of their order or of a mesh.
// Cost:   one look at V_p, the points in nine cells of side 2α.
// Source: Restricted BPA, sections 3.1, "Geometric step", and 3.2; rolling: docs/explanation/paper.md, section 3.
#pragma once

#include <optional>
#include <span>

#include "rbpa/paper/grid.h"

namespace rbpa::paper {

class Ball {
 public:
  /// Makes a ball that sees the given sites only. Refers to the points, which are distinct.
  Ball(std::span<const Point> points, std::span<const Site> sites, Radius alpha)
      : points_(points), alpha_(alpha), grid_(points, sites, alpha) {}

  const Radius& alpha() const { return alpha_; }

  /// Pivots on the Delaunay edge a→b, to its left, until the ball touches a point: the one that sees the edge under the
  /// largest angle (figure 3), ties perturbed. Returns nothing if there is none, or only beyond the ball: R > α.
  /// Requires: |ab| ≤ 2α.
  std::optional<Site> pivot(Site a, Site b) const;

  /// Returns the nearest other point, any of several, unless the ball cannot touch both because it is farther than 2α.
  std::optional<Site> nearest(Site v) const;

  /// Rolls counter-clockwise around v off the point `from` until the ball rests on the next point, which it returns:
  /// `from` after a full turn. Of points that it touches at once, it returns the first counter-clockwise around v.
  /// Requires: a finite radius; at the start, resting on v and `from` with its center left of v→from, the ball is empty
  ///           and touches no other point.
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

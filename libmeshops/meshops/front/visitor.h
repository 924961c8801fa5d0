// What: the events of an advancing front.
#pragma once

#include <array>

#include "meshops/front/front.h"

namespace meshops {

/// A visitor overrides the events it wants; the others cost nothing. The mesh is sound at each of them. It may be a local
/// class, and may throw to end the run.
struct FrontVisitor {
  void seeded(const Front&, const InsertedTriangle&) {}
  void attached(const Front&, Halfedge /*to*/, const InsertedTriangle&) {}
  void frozen(const Front&, Halfedge) {}
  void detached(const Front&, const DetachedTriangle&) {}
  /// What the policy proposed for this edge cannot be: the edge is frozen, which is told after.
  void refused(const Front&, Halfedge, const Refusal&) {}
  /// The same of a seed.
  void seed_refused(const Front&, const std::array<Site, 3>& /*seed*/, const Refusal&) {}

  /// Only a visitor that says true is told of curves: see CurveVisitor.
  static constexpr bool follows_curves = false;
  /// A curve is there now, through this halfedge.
  void curve_begun(const Front&, Halfedge) {}
  /// Two curves have become one, on one component (a handle) or by joining two.
  void curves_joined(const Front&, Halfedge /*through*/) {}
  /// One curve has become two, through these.
  void curve_split(const Front&, Halfedge, Halfedge) {}
  /// A curve has vanished.
  void curve_closed(const Front&) {}
};

/// For who wants the events of curves. Cost: what on_same_curve() does, at every triangle.
struct CurveVisitor : FrontVisitor {
  static constexpr bool follows_curves = true;
};

}  // namespace meshops

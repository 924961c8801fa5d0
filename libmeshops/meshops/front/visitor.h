// What: the events of an advancing front.
#pragma once

#include <array>

#include "meshops/front/front.h"

namespace meshops {

/// A visitor overrides the events that it uses; the others cost nothing. The mesh is sound at each of them. It may be a local
/// class, and may throw to end the run.
struct FrontVisitor {
  void seeded(const Front&, const InsertedTriangle&) {}
  /// A proposal for the boundary halfedge `at` has led to this triangle: its side 0 is `at` when an apex was proposed.
  void attached(const Front&, Halfedge /*at*/, const InsertedTriangle&) {}
  /// The edge stays active, and its turn comes again after a change.
  void deferred(const Front&, Halfedge) {}
  void frozen(const Front&, Halfedge) {}
  void detached(const Front&, const DetachedTriangle&) {}
  /// What the policy proposed for this edge was refused. If the edge is still on the boundary, it is frozen next.
  void refused(const Front&, Halfedge, const Refusal&) {}
  /// The same of a seed.
  void seed_refused(const Front&, const std::array<Site, 3>& /*seed*/, const Refusal&) {}

  /// Only a visitor for which it is true receives the events of curves: see CurveVisitor.
  static constexpr bool follows_curves = false;
  /// A curve has begun, through this halfedge.
  void curve_begun(const Front&, Halfedge) {}
  /// Two curves have become one, on one component (a handle) or by joining two.
  void curves_joined(const Front&, Halfedge /*through*/) {}
  /// One curve has become two, through these.
  void curve_split(const Front&, Halfedge, Halfedge) {}
  /// A curve has vanished.
  void curve_closed(const Front&) {}
};

/// The base of visitors that receive the events of curves. Cost: what on_same_curve() does, at every triangle.
struct CurveVisitor : FrontVisitor {
  static constexpr bool follows_curves = true;
};

}  // namespace meshops

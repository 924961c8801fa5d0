// What: the events that an advancing front reports.
#pragma once

#include <array>

#include "meshops/front/front.h"

namespace meshops {

/// Base of visitors. A visitor declares the events that it uses, with the same parameters; the others cost nothing. The
/// mesh is sound at each event. A visitor may be a local class, and may throw to end the run.
struct FrontVisitor {
  /// Called when a triangle of seed() has been inserted.
  void seeded(const Front&, const InsertedTriangle&) {}
  /// Called when a triangle that was proposed for the boundary halfedge `at` has been inserted. If an apex was
  /// proposed, side 0 of the triangle is `at`.
  void attached(const Front&, Halfedge /*at*/, const InsertedTriangle&) {}
  /// Called when an edge is deferred: the edge stays active, and its turn comes again after a change.
  void deferred(const Front&, Halfedge) {}
  /// Called when the engine has frozen an edge for this level.
  void frozen(const Front&, Halfedge) {}
  /// Called when a triangle has been detached because the policy proposed it (Proposal).
  void detached(const Front&, const DetachedTriangle&) {}
  /// Called when a triangle that was to be inserted or detached, as proposed for this edge, is refused. If the edge is
  /// still on the boundary, it is frozen next (after a list of triangles: unless it is active).
  void refused(const Front&, Halfedge, const Refusal&) {}
  /// Called when a triangle of seed() is refused.
  void seed_refused(const Front&, const std::array<Site, 3>& /*seed*/, const Refusal&) {}

  /// Whether the visitor receives the events of curves, after seeded(), attached() or detached(): see CurveVisitor.
  static constexpr bool follows_curves = false;
  /// Called when a curve has begun, through this halfedge.
  void curve_begun(const Front&, Halfedge) {}
  /// Called when two curves have become one: a handle was made on one component, or two components were joined.
  void curves_joined(const Front&, Halfedge /*through*/) {}
  /// Called when one curve has become two, through these halfedges.
  void curve_split(const Front&, Halfedge, Halfedge) {}
  /// Called when a curve has vanished.
  void curve_closed(const Front&) {}
};

/// Base of visitors that receive the events of curves. Cost: up to six calls of on_same_curve() at every triangle.
struct CurveVisitor : FrontVisitor {
  static constexpr bool follows_curves = true;
};

}  // namespace meshops

// What: the events that an advancing front reports.
#pragma once

#include <array>

#include "meshops/front/front.h"

namespace meshops {

/// Base of visitors. A visitor declares the events that it uses, with the same names and parameters; other events cost
/// nothing. At each event the mesh is sound (core/validate.h). A visitor may be a local class, and may throw to end the
/// run.
struct FrontVisitor {
  /// Called after a triangle of seed() was inserted.
  void seeded(const Front&, const InsertedTriangle&) {}
  /// Called after a triangle that was proposed for the boundary halfedge `at` was inserted. If an apex was proposed,
  /// side 0 of the triangle is `at`.
  void attached(const Front&, Halfedge /*at*/, const InsertedTriangle&) {}
  /// Called after an edge was deferred. The edge stays active, and its turn comes again after a change of the front.
  void deferred(const Front&, Halfedge) {}
  /// Called after the engine froze an edge for this level.
  void frozen(const Front&, Halfedge) {}
  /// Called after a triangle was detached because the policy proposed this (Proposal::detach()).
  void detached(const Front&, const DetachedTriangle&) {}
  /// Called when the front refuses to insert or detach a triangle that was proposed for this edge. Afterwards, the edge
  /// is frozen if it is still on the boundary; after a list of triangles, only if it is also not active.
  void refused(const Front&, Halfedge, const Refusal&) {}
  /// Called when the front refuses a triangle of seed().
  void seed_refused(const Front&, const std::array<Site, 3>& /*seed*/, const Refusal&) {}

  /// Whether the visitor receives the events of curves, after seeded(), attached() or detached(). See CurveVisitor.
  static constexpr bool follows_curves = false;
  /// Called after a curve began. The halfedge is on the curve.
  void curve_begun(const Front&, Halfedge) {}
  /// Called after two curves became one: one component got a handle, or two components were joined.
  void curves_joined(const Front&, Halfedge /*through*/) {}
  /// Called after one curve became two. Each of the two halfedges is on one of the curves.
  void curve_split(const Front&, Halfedge, Halfedge) {}
  /// Called after a curve vanished.
  void curve_closed(const Front&) {}
};

/// Base of visitors that receive the events of curves. Cost: up to six calls of on_same_curve() for every triangle.
struct CurveVisitor : FrontVisitor {
  static constexpr bool follows_curves = true;
};

}  // namespace meshops

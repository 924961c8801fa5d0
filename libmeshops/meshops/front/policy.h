// What:   the two questions an advancing front asks, and the events it tells.
// Source: Medeiros, A topological framework for advancing front triangulations (2003).
#pragma once

#include <array>
#include <concepts>
#include <optional>

#include "meshops/front/front.h"

namespace meshops {

/// A policy knows geometry, the engine topology. Ball pivoting in the plane and in space, and classical advancing-front
/// meshing, are policies.
///   seed(front)        the sites of a triangle that begins a component or touches the mesh in vertices only,
///                      counter-clockwise; nothing when there is none left
///   propose(front, h)  the site at the apex of the triangle to attach to the boundary halfedge h, on its left; nothing
///                      to freeze it. front.sites(), the number after the last site, stands for a new one, which is
///                      added then: so a policy places points.
template <typename P>
concept FrontPolicy = requires(P policy, const Front& front, Halfedge h) {
  { policy.seed(front) } -> std::same_as<std::optional<std::array<Site, 3>>>;
  { policy.propose(front, h) } -> std::same_as<std::optional<Site>>;
};

/// A visitor overrides the events it wants; the others cost nothing. The mesh is sound at each of them.
struct FrontVisitor {
  void seeded(const Front&, const InsertedTriangle&) {}
  void attached(const Front&, Halfedge /*to*/, const InsertedTriangle&) {}
  void frozen(const Front&, Halfedge) {}

  /// Only a visitor that says true is told of curves: it costs what on_same_curve() does at every attachment.
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

}  // namespace meshops

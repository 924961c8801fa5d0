// What:   the functions by which an advancing-front method decides: seeds, proposals, gluing and order.
// Source: Medeiros, A topological framework for advancing front triangulations (2003).
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "meshops/front/front.h"

namespace meshops {

/// Action that a policy proposes for an edge of the front: to attach a triangle with its apex on a site, to insert a
/// list of triangles, to detach a triangle, to defer the edge, or to freeze it.
class Proposal {
 public:
  using Triangle = std::array<Site, 3>;

  /// Proposes a triangle with its apex on a site; without a site, proposes to freeze the edge. Other types are not
  /// accepted, because an int such as −1 is no site.
  template <typename Apex>
  requires std::same_as<Apex, Site> || std::same_as<Apex, std::optional<Site>> Proposal(Apex apex) : apex_(apex) {}
  /// Proposes to freeze the edge.
  Proposal(std::nullopt_t) {}
  /// Proposes to detach a triangle at the front. If the edge still exists afterwards, its turn comes again. If the
  /// front refuses (Front::detach_blocker()), the edge is frozen.
  static Proposal detach(Face f) {
    Proposal proposal(std::nullopt);
    proposal.detached_ = f;
    return proposal;
  }
  /// Proposes triangles for Front::create(), one after another, anywhere. Numbers that follow the last site at the time
  /// of an insertion stand for new sites. The first triangle that is refused ends the list; triangles before it stay.
  /// The edge is frozen if it is then still on the boundary and the visitor has not activated it.
  static Proposal triangles(std::vector<Triangle> triangles) {
    Proposal proposal(std::nullopt);
    proposal.triangles_ = std::move(triangles);
    return proposal;
  }
  /// Proposes to defer the edge. The edge stays active, and its turn comes again if no other edge waits and a triangle
  /// has been inserted or detached since the deferral. Without such a change or another seed, the edge is frozen.
  static Proposal defer() {
    Proposal proposal(std::nullopt);
    proposal.is_deferred_ = true;
    return proposal;
  }

  // The parts of the proposal. If all four are empty or false, the proposal is to freeze the edge.
  const std::optional<Site>& apex() const { return apex_; }
  const std::optional<Face>& detached() const { return detached_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  bool is_deferred() const { return is_deferred_; }

 private:
  std::optional<Site> apex_;
  std::optional<Face> detached_;
  std::vector<Triangle> triangles_;
  bool is_deferred_ = false;
};

/// Policy of an advancing front: the policy decides geometry, the engine decides topology. Ball pivoting in the plane
/// and in space and classical advancing-front meshing are policies. A policy has two functions:
///   seed(front)        returns the sites of a triangle that begins a component or touches the mesh, counter-clockwise;
///                      nothing if there is none left
///   propose(front, h)  returns the site at the apex of the triangle to attach on the left of the boundary halfedge h;
///                      nothing to freeze the edge; or another Proposal
/// The numbers that follow the last site, front.sites() and so on, stand for new sites, which are added together with
/// the triangle: this is how a policy places points. When the front refuses a triangle (Front::attach_blocker()), the
/// engine calls the visitor and freezes the edge.
template <typename P>
concept FrontPolicy = requires(P policy, const Front& front, Halfedge h) {
  { policy.seed(front) } -> std::same_as<std::optional<std::array<Site, 3>>>;
  { policy.propose(front, h) } -> std::convertible_to<Proposal>;
};

/// Policy that decides which sides are glued. Without glues(), the sites decide: between two sites there is one edge.
///   glues(front, h, apex)  returns whether the boundary halfedge h is glued to the side between the same sites of a
///                          triangle whose third corner is `apex`. The engine calls it for one boundary halfedge
///                          between the sites after another, until a call returns true; if none does, the side is a new
///                          edge. The edge for which an apex was proposed is glued without a call.
/// With glues(), any number of triangles can lie between two sites, in pairs or each with its own edge, and a site
/// around which faces close can have further fans. A triangle that exists already is refused.
template <typename P>
concept GluingFrontPolicy = FrontPolicy<P> && requires(P policy, const Front& front, Halfedge h, Site apex) {
  { policy.glues(front, h, apex) } -> std::same_as<bool>;
};

/// Policy with an order of its own:
///   key(front, h)      returns the key of a boundary halfedge that has become active. The least key comes first, and
///                      among equal keys the halfedge that became active first. The engine calls key() before the next
///                      proposal, once each time that a halfedge becomes active and is still active then. key() must
///                      not change the front.
/// Without key(), the order is first in, first out. A member named `key` or `glues` of another form is an error at
/// compile time, and so is a member that a `requires` clause disables: declare that in a class derived from the policy.
template <typename P>
concept OrderedFrontPolicy = FrontPolicy<P> && requires(P policy, const Front& front, Halfedge h) {
  { policy.key(front, h) } -> std::totally_ordered;
};

/// Policy whose keys depend on neighbors along the curve, as angles between edges do. If a policy declares
///   static constexpr bool rekeys_neighbors = true;
/// the engine computes the keys of the two boundary halfedges at each corner of a triangle that was inserted or
/// detached again, if they are active. Their order among equal keys does not change: if no triangle is detached and
/// each new key equals the old key, the run is the same.
template <typename P>
concept RekeyingFrontPolicy = OrderedFrontPolicy<P> && requires {
  requires std::bool_constant<P::rekeys_neighbors>::value;
};

}  // namespace meshops

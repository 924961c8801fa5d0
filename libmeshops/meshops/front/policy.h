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

/// Action that a policy proposes for an edge of the front: attach a triangle with its apex on a site, insert a list of
/// triangles, detach a triangle, defer the edge, or freeze it.
class Proposal {
 public:
  using Triangle = std::array<Site, 3>;

  /// Proposes a triangle with its apex on a site, or to freeze the edge when the optional is empty. Other types are not
  /// accepted: the −1 of an int is no site.
  template <typename Apex>
  requires std::same_as<Apex, Site> || std::same_as<Apex, std::optional<Site>> Proposal(Apex apex) : apex_(apex) {}
  /// Proposes to freeze the edge.
  Proposal(std::nullopt_t) {}
  /// Proposes to detach a triangle at the front. If the edge still exists afterwards, its turn comes again; if the
  /// front refuses (Front::detach_blocker), the edge is frozen.
  static Proposal detach(Face f) {
    Proposal proposal(std::nullopt);
    proposal.detached_ = f;
    return proposal;
  }
  /// Proposes triangles for Front::create(), one after another, anywhere. A number that follows the last site at the
  /// time of the insertion stands for a new site. The first triangle that is refused ends the list; those before it
  /// stay. The edge is frozen if it is still on the boundary afterwards and the visitor has not activated it.
  static Proposal triangles(std::vector<Triangle> triangles) {
    Proposal proposal(std::nullopt);
    proposal.triangles_ = std::move(triangles);
    return proposal;
  }
  /// Proposes to defer the edge: the edge stays active, and its turn comes again when no other edge waits and a
  /// triangle has been inserted or detached since. Without such a change and without another seed, the edge is frozen.
  static Proposal defer() {
    Proposal proposal(std::nullopt);
    proposal.is_deferred_ = true;
    return proposal;
  }

  // The proposal. If all four are empty or false, it is to freeze the edge.
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

/// Policy of an advancing front: it decides geometry, the engine decides topology. Methods such as ball pivoting in the
/// plane and in space, or classical advancing-front meshing, are policies. A policy has two functions:
///   seed(front)        returns the sites of a triangle that begins a component or touches the mesh, counter-clockwise;
///                      nothing when there is none left
///   propose(front, h)  returns the site at the apex of the triangle to attach to the boundary halfedge h, on its left;
///                      nothing to freeze it; or another Proposal
/// The numbers that follow the last site, front.sites() and so on, stand for new sites, which are added together with
/// the triangle: this is how a policy places points. When the front refuses a triangle (Front::attach_blocker), the
/// visitor is called, and the edge is frozen.
template <typename P>
concept FrontPolicy = requires(P policy, const Front& front, Halfedge h) {
  { policy.seed(front) } -> std::same_as<std::optional<std::array<Site, 3>>>;
  { policy.propose(front, h) } -> std::convertible_to<Proposal>;
};

/// Policy that decides which sides are glued. Other policies leave this to sites: between two sites there is one edge.
///   glues(front, h, apex)  returns whether the boundary halfedge h is glued to the side, between the same sites, of a
///                          triangle whose third corner is the apex. It is called for one boundary halfedge between the
///                          sites after another, until it returns true; without one, the side is a new edge. The edge
///                          for which an apex was proposed is glued without a call.
/// With this function, any number of triangles can lie between two sites, in pairs or each with an edge of its own, and
/// a site around which faces close can have further fans. A triangle that exists already is refused.
template <typename P>
concept GluingFrontPolicy = FrontPolicy<P> && requires(P policy, const Front& front, Halfedge h, Site apex) {
  { policy.glues(front, h, apex) } -> std::same_as<bool>;
};

/// Policy with an order of its own:
///   key(front, h)      returns the key of a boundary halfedge that has become active: the least key comes first, of
///                      equal keys the halfedge that became active first. It is called before the next proposal, once
///                      each time that a halfedge becomes active and still is then, and must not change the front.
/// Without key() the order is first in, first out. A member named `key` or `glues` of another form is an error at
/// compile time, and so is one that a `requires` clause disables: declare that one in a class derived from the policy.
template <typename P>
concept OrderedFrontPolicy = FrontPolicy<P> && requires(P policy, const Front& front, Halfedge h) {
  { policy.key(front, h) } -> std::totally_ordered;
};

/// Policy whose keys depend on the neighbors on the curve, as angles between edges do. A policy that declares
///   static constexpr bool rekeys_neighbors = true;
/// is called again for the keys of both boundary halfedges at each corner of a triangle that was inserted or detached,
/// if they are active. Their order among equal keys stays the same: if no triangle is detached, and the new keys equal
/// the old ones, the run is the same.
template <typename P>
concept RekeyingFrontPolicy = OrderedFrontPolicy<P> && requires {
  requires std::bool_constant<P::rekeys_neighbors>::value;
};

}  // namespace meshops

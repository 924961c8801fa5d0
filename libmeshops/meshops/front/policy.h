// What:   the functions that an advancing front calls, by which methods differ.
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

/// What is to be done at an edge of the front: attach a triangle with its apex on a site, insert a list of triangles,
/// detach a triangle, defer the edge, or freeze it.
class Proposal {
 public:
  using Triangle = std::array<Site, 3>;

  /// The site at the apex; nothing to freeze the edge. Of no other type: the −1 of an int is no site.
  template <typename Apex>
  requires std::same_as<Apex, Site> || std::same_as<Apex, std::optional<Site>> Proposal(Apex apex) : apex_(apex) {}
  Proposal(std::nullopt_t) {}
  /// A triangle at the front is detached, and the policy is called again for the edge, if it still exists, when its turn comes.
  static Proposal detach(Face f) {
    Proposal proposal(std::nullopt);
    proposal.detached_ = f;
    return proposal;
  }
  /// Triangles for Front::create(), one after another, wherever they lie: each takes a number that follows the last site for
  /// a new one when it is inserted. The first that is refused ends the list; those before it stay. The edge is frozen if it
  /// is still on the boundary then.
  static Proposal triangles(std::vector<Triangle> triangles) {
    Proposal proposal(std::nullopt);
    proposal.triangles_ = std::move(triangles);
    return proposal;
  }
  /// The edge stays active, and its turn comes again when no other edge waits and a triangle has been inserted or detached
  /// since. Without such a change, and without another seed, it is frozen.
  static Proposal defer() {
    Proposal proposal(std::nullopt);
    proposal.is_deferred_ = true;
    return proposal;
  }

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

/// A policy decides geometry, the engine topology. Ball pivoting in the plane and in space, and classical advancing-front
/// meshing, are policies.
///   seed(front)        the sites of a triangle that begins a component or touches the mesh, counter-clockwise; nothing
///                      when there is none left
///   propose(front, h)  the site at the apex of the triangle to attach to the boundary halfedge h, on its left; nothing
///                      to freeze it; or another Proposal
/// The numbers that follow the last site, front.sites() and so on, stand for new ones, which are added when the triangle
/// is: so a policy places points. A triangle that the front refuses (Front::attach_blocker) is not attached: the edge is
/// frozen, and the visitor is called.
template <typename P>
concept FrontPolicy = requires(P policy, const Front& front, Halfedge h) {
  { policy.seed(front) } -> std::same_as<std::optional<std::array<Site, 3>>>;
  { policy.propose(front, h) } -> std::convertible_to<Proposal>;
};

/// A policy may decide which sides are glued. Without that, sites decide: between two of them there is one edge.
///   glues(front, h, apex)  the boundary halfedge h is glued to the side, between the same sites, of a triangle whose third
///                          corner is the apex. It is called for the halfedges that exist when a triangle is inserted;
///                          where it returns false for all of them, the side is a new edge.
/// With it, any number of triangles can lie at two sites, in pairs or each with an edge of its own, and a site around which
/// faces close can have further fans. A triangle is refused when it exists already.
template <typename P>
concept GluingFrontPolicy = FrontPolicy<P> && requires(P policy, const Front& front, Halfedge h, Site apex) {
  { policy.glues(front, h, apex) } -> std::same_as<bool>;
};

/// A policy may have an order of its own.
///   key(front, h)      of a boundary halfedge that has become active: the least comes first, of equal ones the oldest. It
///                      is called once each time, and must not change the front.
/// Without it the order is first in, first out. A member with this name, or the name `glues`, that has another form is an
/// error when compiling, and not passed over; so is one that a `requires` clause disables: put it into a class derived of
/// the policy.
template <typename P>
concept OrderedFrontPolicy = FrontPolicy<P> && requires(P policy, const Front& front, Halfedge h) {
  { policy.key(front, h) } -> std::totally_ordered;
};

/// Keys may depend on the neighbors on the curve, as angles between edges do. A policy that declares it,
///   static constexpr bool rekeys_neighbours = true;
/// is called again for the keys of both boundary halfedges at each corner of a triangle that was inserted or detached, if
/// they are active. Their age stays: where no triangle is detached, keys that stay the same make the same run.
template <typename P>
concept RekeyingFrontPolicy = OrderedFrontPolicy<P> && requires {
  requires std::bool_constant<P::rekeys_neighbours>::value;
};

}  // namespace meshops

// What:   the advancing-front engine: calls a policy edge by edge until nothing is left to do.
// Law:    when advance() returns, every boundary halfedge is frozen, except halfedges that the caller holds after
//         pop(). The mesh is sound, whatever the policy returns. With a fixed number of sites, the engine terminates
//         unless the policy detaches triangles forever, the policy returns refused seeds forever and never the same
//         seed twice in a row, or the visitor activates edges forever.
// Cost:   one proposal for each turn of an active boundary halfedge; with a key(), also the logarithm of the number of
//         active halfedges for each turn.
// Source: Medeiros, A topological framework for advancing front triangulations (2003); Restricted BPA, section 3.1,
//         "Algorithm outline".
#pragma once

#include <type_traits>

#include "meshops/front/near_miss.h"
#include "meshops/front/policy.h"
#include "meshops/front/run.h"
#include "meshops/front/visitor.h"

namespace meshops {

/// Advances the front until no halfedge is active, then inserts a seed and continues. Ends when seed() returns nothing,
/// or returns the seed refused last with no triangle inserted or detached since the refusal. Deferred edges get their
/// turn again before the next seed, if no other edge is active and a triangle was inserted or detached after they were
/// deferred; if there is no seed, they are frozen, and seed() is called once more. An edge is frozen if the policy
/// proposes nothing for it, if its proposal is refused, or if the triangles proposed for it leave it on the boundary.
/// Throws: whatever the policy or the visitor throws, including the comparisons and moves of keys. The mesh is then
///         sound. The edges that were active or in processing are active, and another advance() continues with them in
///         the same order. ContractViolation if the mesh or the front is changed during a call: by the policy in any
///         way, by the visitor in any way but activate() and freeze().
template <FrontPolicy Policy, typename Visitor>
void advance(Front& front, Policy& policy, Visitor&& visitor) {
  static_assert(!detail::misses_key<Policy>,
                "the policy has a member key that is ignored: expected key(const Front&, Halfedge), public, of a "
                "type that is std::totally_ordered");
  static_assert(
      !detail::misses_glues<Policy>,
      "the policy has a member glues that is ignored: expected bool glues(const Front&, Halfedge, Site), public");
  static_assert(!detail::misses_rekeys<Policy>,
                "the policy has a member rekeys_neighbors that is ignored: expected static constexpr bool "
                "rekeys_neighbors, public, beside a member key");
  static_assert(!detail::misses_curves<std::remove_cvref_t<Visitor>>(),
                "the visitor has events of curves that are ignored: expected it to derive from CurveVisitor");
  static_assert(
      !detail::misses_events<std::remove_cvref_t<Visitor>>(),
      "the visitor has no event, or a member with nearly the name of one, which is ignored: expected seeded, "
      "attached, deferred, frozen, detached, refused, seed_refused, curve_begun, curves_joined, curve_split or "
      "curve_closed");
  detail::Run<Policy, std::remove_reference_t<Visitor>>(front, policy, visitor).advance();
}

/// Advances the front as the overload above does, without a visitor.
template <FrontPolicy Policy>
void advance(Front& front, Policy& policy) {
  advance(front, policy, FrontVisitor{});
}

}  // namespace meshops

// What:   the advancing-front engine.
// Law:    when it returns, every boundary halfedge is frozen: the policy proposed nothing for it, or a triangle that was
//         refused. Whatever a policy returns, the mesh is sound; and on a given number of sites the engine terminates,
//         unless the policy detaches triangles again and again, or returns ever new seeds that are refused.
// Cost:   one proposal per active halfedge that is still on the boundary when its turn comes, and one more each time that it
//         was deferred; and what an order costs.
// Source: Medeiros, A topological framework for advancing front triangulations (2003); Restricted BPA, section 3.1,
//         "Algorithm outline".
#pragma once

#include <type_traits>

#include "meshops/front/near_miss.h"
#include "meshops/front/policy.h"
#include "meshops/front/run.h"
#include "meshops/front/visitor.h"

namespace meshops {

/// Advances the active front until it runs dry, and then from seed to seed until no seed is left, or the same is refused
/// twice in a row. After Front::next_level() it begins with what was frozen. Deferred edges come whenever the front runs dry
/// before the next seed, and are frozen when there is none; then seed() is called once more.
/// Throws: whatever the policy or the visitor throws, a key's order and moves included; the mesh is sound then, what was
///         active or in hand is active, and another advance() continues with it, in the order in which this one would have.
///         ContractViolation when the mesh is changed meanwhile, or the front: by the policy at all, by the visitor other
///         than by activate() and freeze().
template <FrontPolicy Policy, typename Visitor>
void advance(Front& front, Policy& policy, Visitor&& visitor) {
  static_assert(!detail::misses_key<Policy>,
                "the policy has a member key that is ignored: expected key(const Front&, Halfedge), public, of a "
                "type that is std::totally_ordered");
  static_assert(
      !detail::misses_glues<Policy>,
      "the policy has a member glues that is ignored: expected bool glues(const Front&, Halfedge, Site), public");
  static_assert(!detail::misses_rekeys<Policy>,
                "the policy has a member rekeys_neighbours that is ignored: expected static constexpr bool "
                "rekeys_neighbours, public, beside a member key");
  static_assert(!detail::misses_curves<std::remove_cvref_t<Visitor>>(),
                "the visitor has events of curves that are ignored: expected it to derive from CurveVisitor");
  static_assert(
      !detail::misses_events<std::remove_cvref_t<Visitor>>(),
      "the visitor has no event, or a member with nearly the name of one, which is ignored: expected seeded, "
      "attached, deferred, frozen, detached, refused, seed_refused, curve_begun, curves_joined, curve_split or "
      "curve_closed");
  detail::Run<Policy, std::remove_reference_t<Visitor>>(front, policy, visitor).advance();
}

/// Without a visitor.
template <FrontPolicy Policy>
void advance(Front& front, Policy& policy) {
  advance(front, policy, FrontVisitor{});
}

}  // namespace meshops

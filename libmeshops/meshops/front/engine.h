// What:   the advancing-front engine.
// Law:    when it returns, every boundary halfedge is frozen: the policy proposed nothing for it, or nothing that could
//         be. Whatever a policy answers, the mesh is sound; and on a given number of sites the engine comes to an end,
//         unless the policy detaches triangles again and again, or asks for ever other seeds that are refused.
// Cost:   one proposal per active halfedge that is still on the boundary when its turn comes; and what an order costs.
// Source: Medeiros, A topological framework for advancing front triangulations (2003); Restricted BPA, section 3.1,
//         "Algorithm outline".
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "meshops/front/curve_events.h"
#include "meshops/front/engine_side.h"
#include "meshops/front/near_miss.h"
#include "meshops/front/order.h"
#include "meshops/front/policy.h"
#include "meshops/front/visitor.h"

namespace meshops {

namespace detail {

/// Inserts a triangle that fits, and tells what it did to curves. `tell` tells the rest, before that.
template <typename Visitor, typename Tell>
void insert(Front& front, const Fit& fit, Visitor& visitor, Tell tell) {
  std::size_t before = 0;
  if constexpr (Visitor::follows_curves) before = DistinctCurves(front.mesh(), fit.sides.side).count();
  const InsertedTriangle triangle = front.insert(fit);
  EngineSide(front).tell([&] { tell(triangle); });
  if constexpr (Visitor::follows_curves)
    tell_curves(front, before, DistinctCurves(front.mesh(), corners(front.mesh(), triangle.face)), visitor);
}

template <typename Visitor>
void detach(Front& front, Face f, Visitor& visitor) {
  std::size_t before = 0;
  if constexpr (Visitor::follows_curves) before = DistinctCurves(front.mesh(), corners(front.mesh(), f)).count();
  const DetachedTriangle triangle = front.detach(f);
  EngineSide(front).tell([&] { visitor.detached(std::as_const(front), triangle); });
  if constexpr (Visitor::follows_curves)
    tell_curves(front, before, DistinctCurves(front.mesh(), triangle.side), visitor);
}

template <typename Visitor>
void freeze(Front& front, Halfedge h, Visitor& visitor) {
  front.freeze(h);
  EngineSide(front).tell([&] { visitor.frozen(std::as_const(front), h); });
}

/// Where a triangle goes, given by its corners or by a halfedge and the apex: glued as its sites tell, or as the policy
/// says.
template <typename Policy, typename... Place>
Fit fit(Front& front, Policy& policy, Place... place) {
  if constexpr (GluingFrontPolicy<Policy>)
    return front.fit(place..., [&](Halfedge side, Site apex) {
      return EngineSide(front).ask([&] { return policy.glues(std::as_const(front), side, apex); });
    });
  else
    return front.fit(place...);
}

/// Does what the policy wants of an edge.
template <typename Policy, typename Visitor>
void follow(Front& front, Policy& policy, Halfedge h, const Proposal& proposal, Visitor& visitor) {
  const Front& seen = front;
  std::optional<Refusal> refusal;
  if (proposal.detached()) {
    refusal = front.detach_blocker(*proposal.detached());
    if (!refusal) {
      front.activate(h);  // it may go with the triangle
      detach(front, *proposal.detached(), visitor);
      return;
    }
  } else if (proposal.apex()) {
    const Fit fit = detail::fit(front, policy, h, *proposal.apex());
    refusal = fit.refusal;
    if (!refusal) {
      insert(front, fit, visitor, [&](const InsertedTriangle& triangle) { visitor.attached(seen, h, triangle); });
      return;
    }
  }
  if (refusal) EngineSide(front).tell([&] { visitor.refused(seen, h, *refusal); });
  freeze(front, h, visitor);
}

/// The next seed that fits, inserted; false when there is none.
template <typename Policy, typename Visitor>
bool begin(Front& front, Policy& policy, Visitor& visitor) {
  const Front& seen = front;
  std::optional<std::array<Site, 3>> refused;
  for (;;) {
    const std::optional<std::array<Site, 3>> seed = EngineSide(front).ask([&] { return policy.seed(seen); });
    // A policy that says the same again knows no other.
    if (!seed || seed == refused) return false;
    const Fit fit = detail::fit(front, policy, (*seed)[0], (*seed)[1], (*seed)[2]);
    if (!fit.refusal) {
      insert(front, fit, visitor, [&](const InsertedTriangle& triangle) { visitor.seeded(seen, triangle); });
      return true;
    }
    EngineSide(front).tell([&] { visitor.seed_refused(seen, *seed, *fit.refusal); });
    refused = seed;
  }
}

}  // namespace detail

/// Advances the active front until it runs dry, and then from seed to seed until no seed is left, or the same is refused
/// twice in a row. After Front::next_level() it begins with what was frozen.
/// Throws: whatever the policy or the visitor throws, a key's order and moves included; the mesh is sound then, what was
///         active or in hand is active, and another advance() asks about it, in the order in which this one would have.
///         ContractViolation when the mesh is changed meanwhile, or the front: by the policy at all, by the visitor other
///         than by activate() and freeze().
template <FrontPolicy Policy, typename Visitor>
void advance(Front& front, Policy& policy, Visitor&& visitor) {
  static_assert(!detail::misses_key<Policy>,
                "the policy has a member key that is passed over: expected key(const Front&, Halfedge), public, of a "
                "type that is "
                "std::totally_ordered");
  static_assert(
      !detail::misses_glues<Policy>,
      "the policy has a member glues that is passed over: expected bool glues(const Front&, Halfedge, Site), public");
  static_assert(!detail::misses_curves<std::remove_cvref_t<Visitor>>(),
                "the visitor has events of curves that are passed over: expected it to derive from CurveVisitor");
  typename detail::OrderOf<Policy>::type order(front, policy);
  const detail::EngineSide engine(front);
  Halfedge h;
  try {
    do {
      for (h = order.next(); h.is_valid(); h = order.next())
        detail::follow(front, policy, h,
                       engine.ask([&]() -> Proposal { return policy.propose(std::as_const(front), h); }), visitor);
    } while (detail::begin(front, policy, visitor));
  } catch (...) {
    order.give_back(h);
    throw;
  }
}

/// Without a visitor.
template <FrontPolicy Policy>
void advance(Front& front, Policy& policy) {
  advance(front, policy, FrontVisitor{});
}

}  // namespace meshops

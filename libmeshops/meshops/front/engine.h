// What:   the advancing-front engine.
// Law:    when it returns, every boundary halfedge is frozen: the policy proposed nothing for it.
// Cost:   one proposal per active halfedge that is still on the boundary when its turn comes, breadth first.
// Source: Medeiros, A topological framework for advancing front triangulations (2003); Restricted BPA, section 3.1,
//         "Algorithm outline".
#pragma once

#include "meshops/front/curve_events.h"
#include "meshops/front/policy.h"

namespace meshops {

namespace detail {

/// Begins a component at a seed, or where it touches the mesh.
template <typename Visitor>
void begin(Front& front, const std::array<Site, 3>& seed, Visitor& visitor) {
  std::size_t before = 0;
  if constexpr (Visitor::follows_curves)
    before = curves_before(front.mesh(), front.sides_of(seed[0], seed[1], seed[2]));
  const InsertedTriangle triangle = front.create(seed[0], seed[1], seed[2]);
  visitor.seeded(front, triangle);
  if constexpr (Visitor::follows_curves) tell_curves(front, triangle, before, visitor);
}

/// Attaches a triangle, whose apex may be a site that does not exist yet.
template <typename Visitor>
void attach(Front& front, Halfedge h, Site apex, Visitor& visitor) {
  if (static_cast<std::size_t>(apex) == front.sites()) front.add_site();
  std::size_t before = 0;
  if constexpr (Visitor::follows_curves) before = curves_before(front.mesh(), front.sides_of(h, apex));
  const InsertedTriangle triangle = front.attach(h, apex);
  visitor.attached(front, h, triangle);
  if constexpr (Visitor::follows_curves) tell_curves(front, triangle, before, visitor);
}

}  // namespace detail

/// Advances the active front until it runs dry, and then from seed to seed until no seed is left. After
/// Front::next_level() it begins with what was frozen.
/// Throws: whatever the policy or the visitor throws; the mesh is sound then.
template <FrontPolicy Policy, typename Visitor>
void advance(Front& front, Policy& policy, Visitor& visitor) {
  for (;;) {
    for (Halfedge h = front.pop(); h.is_valid(); h = front.pop()) {
      if (const auto apex = policy.propose(front, h)) {
        detail::attach(front, h, *apex, visitor);
      } else {
        front.freeze(h);
        visitor.frozen(front, h);
      }
    }
    const auto seed = policy.seed(front);
    if (!seed) return;
    detail::begin(front, *seed, visitor);
  }
}

}  // namespace meshops

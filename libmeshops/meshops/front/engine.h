// What:   the advancing-front engine.
// Law:    when it returns, every boundary halfedge is frozen: the policy proposed nothing for it.
// Cost:   one proposal per active halfedge that is still on the boundary when its turn comes, breadth first.
// Source: Medeiros, A topological framework for advancing front triangulations (2003); Restricted BPA, section 3.1,
//         "Algorithm outline".
#pragma once

#include "meshops/front/policy.h"

namespace meshops {

/// Advances the front from every seed until it runs dry and no seed is left.
/// Throws: whatever the policy or the visitor throws; the mesh is sound then.
template <FrontPolicy Policy, typename Visitor>
void advance(Front& front, Policy& policy, Visitor& visitor) {
  while (const auto seed = policy.seed(front)) {
    visitor.seeded(front, front.create((*seed)[0], (*seed)[1], (*seed)[2]));
    for (Halfedge h = front.pop(); h.is_valid(); h = front.pop()) {
      if (const auto apex = policy.propose(front, h)) {
        visitor.attached(front, h, front.attach(h, *apex));
      } else {
        front.freeze(h);
        visitor.frozen(front, h);
      }
    }
  }
}

}  // namespace meshops

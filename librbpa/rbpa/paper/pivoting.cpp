#include "rbpa/paper/pivoting.h"

#include "meshops/front/engine.h"

namespace rbpa::paper {

std::optional<Site> RestrictedBallPivoting::propose(const Front& front, Halfedge h) {
  if (observe_) observe_(front);
  return ball_.pivot(front.from_site(h), front.to_site(h));
}

// Runs the "Algorithm outline" of section 3.1. meshops::advance() calls seed() again and again, and propose() for each
// edge of the front; Front::attach() joins and splits boundary curves by gluing.
void rbpa(std::span<const Point> points, Radius alpha, Front& front, Monitor& monitor) {
  RestrictedBallPivoting policy(points, front.next_level().carried, alpha,
                                [&](const Front& seen) { monitor.searched(seen); });
  meshops::advance(front, policy, monitor);
}

}  // namespace rbpa::paper

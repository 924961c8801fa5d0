// Ideal seeds, which Theorem 1 requires. A triangle that the front does not reach has no edge in the mesh, and its
// corners are isolated or on the boundary. At such a corner v:
//   1. The ball rests on v and a point `from`: the end of the last edge of a fan, or, at an isolated v, the nearest
//      point. The complex has no further triangle beside the edge from v to `from`.
//   2. The ball rolls around v until it touches a point q. The edge vq has no triangle on its right. A pivot tests
//      whether the complex has a triangle on its left, which is then a seed.
//   3. Otherwise the ball rolls on, until it is back at `from` or at the first edge of a fan.
// docs/explanation/paper.md, section 7, proves that this search finds every triangle.
#include "rbpa/paper/pivoting.h"

namespace rbpa::paper {

std::optional<Triangle> RestrictedBallPivoting::seed(const Front& front) {
  // With an infinite radius, the complex is connected through edges, so one seed is enough.
  if (ball_.alpha().is_infinite() && front.faces() > 0) return std::nullopt;
  for (; next_ < sites_.size(); ++next_) {
    if (observe_) observe_(front);
    const Site v = sites_[next_];
    const auto seed = front.is_free(v) ? seed_at_isolated(front, v) : seed_at_boundary(front, v);
    if (seed) return seed;
  }
  return std::nullopt;
}

std::optional<Triangle> RestrictedBallPivoting::seed_at_isolated(const Front& front, Site v) const {
  const auto u = ball_.nearest(v);
  if (!u) return std::nullopt;
  if (const auto seed = triangle_left_of(v, *u)) return seed;
  if (const auto seed = triangle_left_of(*u, v)) return seed;
  return ball_.alpha().is_infinite() ? std::nullopt : roll_to_seed(front, v, *u);
}

std::optional<Triangle> RestrictedBallPivoting::seed_at_boundary(const Front& front, Site v) const {
  std::optional<Triangle> seed;
  front.for_each_fan(v, [&](meshops::Vertex fan) {
    const Halfedge last = front.mesh().halfedge_handle(fan);
    if (!seed && front.mesh().is_boundary(last)) seed = roll_to_seed(front, v, front.to_site(last));
  });
  return seed;
}

std::optional<Triangle> RestrictedBallPivoting::roll_to_seed(const Front& front, Site v, Site from) const {
  for (Site q = ball_.roll(v, from); q != from && !front.edge_between(v, q).is_valid(); q = ball_.roll(v, q))
    if (const auto seed = triangle_left_of(v, q)) return seed;
  return std::nullopt;
}

std::optional<Triangle> RestrictedBallPivoting::triangle_left_of(Site a, Site b) const {
  const auto apex = ball_.pivot(a, b);
  return apex ? std::optional(Triangle{a, b, *apex}) : std::nullopt;
}

}  // namespace rbpa::paper

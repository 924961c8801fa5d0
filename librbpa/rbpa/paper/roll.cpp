// The ball turns counter-clockwise around v. It arrives at a point p with its center right of v→p, and leaves p with
// its center left of v→p. Signs decide at which of two points the ball arrives first, without any angle or root
// (docs/explanation/paper.md, section 5). The result is the first of all points within 2α of v.
#include "rbpa/paper/circle.h"

namespace rbpa::paper {

Site Ball::roll(Site v, Site from) const {
  Site next = from;
  grid_.for_each_near(v, [&](Site q) {
    if (q == v || q == from || !alpha_.spans<Real>(at(v), at(q))) return;
    if (in_arriving_ball(v, q, from)) return;  // hidden behind `from`: the ball returns to `from` earlier
    if (next == from || met_before(v, from, q, next)) next = q;
  });
  return next;
}

/// Returns whether the ball arrives at q before p. Requires: neither is hidden behind `from`.
bool Ball::met_before(Site v, Site from, Site q, Site p) const {
  // The ball that arrives at one point has met every point inside before.
  if (in_arriving_ball(v, p, q)) return true;
  if (in_arriving_ball(v, q, p)) return false;
  // Otherwise the ball meets both points simultaneously, or in their counter-clockwise order around v from v→from on.
  const int side_of_q = P::orientation(at(v), at(from), at(q)), side_of_p = P::orientation(at(v), at(from), at(p));
  if (side_of_q != side_of_p) return side_of_q > side_of_p;
  return P::orientation(at(v), at(q), at(p)) > 0;
}

/// Returns whether q is inside the ball that arrives at p. The angle at q decides (docs/explanation/paper.md, section
/// 6).
bool Ball::in_arriving_ball(Site v, Site p, Site q) const {
  const int side = P::orientation(at(v), at(p), at(q));
  const int cosine = P::dot_sign(at(q), at(v), at(p));
  if (side == 0) return cosine < 0;  // q is between v and p
  const auto radius_to_alpha = [&] { return P::compare_circumradius(at(v), at(p), at(q), alpha_.value()); };
  const bool is_beside_center = side < 0;
  return is_beside_center ? cosine < 0 || radius_to_alpha() < 0 : cosine < 0 && radius_to_alpha() > 0;
}

}  // namespace rbpa::paper

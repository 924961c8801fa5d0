#include "rbpa/paper/circle.h"

namespace rbpa::paper {

std::optional<Site> Ball::pivot(Site a, Site b) const {
  // If one of two points left of the edge is inside the circle through a, b and the other point, the inner point sees
  // the edge under the larger angle.
  std::optional<Site> best;
  grid_.for_each_near(a, b, [&](Site p) {
    if (P::orientation(at(a), at(b), at(p)) <= 0) return;
    if (!best || P::in_perturbed_circle(at(a), at(b), at(*best), at(p)) > 0) best = p;
  });
  if (!best || !alpha_.admits<Real>(at(a), at(b), at(*best))) return std::nullopt;
  return best;
}

std::optional<Site> Ball::nearest(Site v) const {
  std::optional<Site> best;
  grid_.for_each_near(v, [&](Site p) {
    if (p != v && (!best || P::compare_distances(at(v), at(p), at(*best)) < 0)) best = p;
  });
  if (!best || !alpha_.spans<Real>(at(v), at(*best))) return std::nullopt;
  return best;
}

}  // namespace rbpa::paper

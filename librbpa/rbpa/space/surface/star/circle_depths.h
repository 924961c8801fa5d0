// What: computes how deep the circle of a point, on which the centers of balls that touch it lie, reaches into the cap
//       of another point.
// Law:  correct within the errors that limits.h allows.
#pragma once

#include <algorithm>
#include <cmath>

#include "rbpa/space/surface/star/limits.h"
#include "rbpa/space/surface/star/neighbor.h"

namespace rbpa::space {

/// The extremes of the depth c · p − p²/2 for c on the circle of q, along which it is a cosine; and a bound of their
/// errors.
struct CircleDepths {
  double greatest, least, error;
};

/// Returns the extremes. Requires: `size` is p.size().
inline CircleDepths depths_on_circle(const Neighbor& p, double size, const Neighbor& q, double radius) {
  const double along = dot(p.at, q.at), qq = 2 * q.power;
  const double across = std::sqrt(std::max(0.0, 2 * p.power - along * along / qq));
  const double half_range = std::sqrt(std::max(0.0, radius * radius - qq / 4)) * across;
  return {along / 2 + half_range - p.power, along / 2 - half_range - p.power, limits::extreme * radius * size};
}

}  // namespace rbpa::space

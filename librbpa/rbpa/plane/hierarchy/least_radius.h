// What:   the least radius of a hierarchy, α₀: half the side of the smallest leaf of a quadtree.
// Source: Restricted BPA, section 6, "Minimal radius estimation".
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "rbpa/plane/grid/sites.h"
#include "rbpa/plane/hierarchy/quadtree.h"

namespace rbpa {

/// Returns α₀ for leaves of at most `leaf_capacity` points. Calls `checkpoint`, if any, repeatedly while squares have
/// more than 4,096 points; `checkpoint` may throw.
inline double least_radius(const Sites& sites, std::size_t leaf_capacity, const Checkpoint& checkpoint) {
  long double side = 0;
  if (sites.beyond().empty()) {
    const Quadtree<double> tree(sites.grid().points(), leaf_capacity);
    side = std::ldexp(static_cast<long double>(tree.smallest_side(checkpoint)), -sites.window().exponent);
  } else {
    side = Quadtree<long double>(sites.points(), leaf_capacity).smallest_side(checkpoint);
  }
  using Limits = std::numeric_limits<double>;
  return static_cast<double>(std::clamp<long double>(side / 2, Limits::denorm_min(), Limits::max()));
}

}  // namespace rbpa

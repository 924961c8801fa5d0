// What: a part of the plane that owns points, and the points that it has to be given.
// Law:  regions that share no point of the plane share no item of the complex: a triangle is of the region that has its
//       lexicographically least corner, an edge of the one that has its lesser end, a vertex of its own.
// Source: docs/partial.md.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"

namespace rbpa {

/// The half-open box [x0, x1) × [y0, y1); the whole plane unless said. Bounds may be infinite; where x0 = x1 or y0 = y1 it
/// has no point. −0 equals +0.
struct Region {
  double x0 = -std::numeric_limits<double>::infinity();
  double y0 = -std::numeric_limits<double>::infinity();
  double x1 = std::numeric_limits<double>::infinity();
  double y1 = std::numeric_limits<double>::infinity();

  bool contains(const Point& p) const { return x0 <= p.x && p.x < x1 && y0 <= p.y && p.y < y1; }
  friend bool operator==(const Region&, const Region&) = default;
};

/// A box that has every point within 2 alpha of a point of the region, the distance itself included. It is rounded outward,
/// and has some points that are farther.
/// Throws: InvalidInput unless 0 < alpha < ∞ and the region's bounds are numbers in ascending order.
RBPA_API Region halo(const Region& region, double alpha);

/// What a region is computed from: all points that it has, and all others of its halo. More points do no harm.
struct RegionPoints {
  std::span<const Point> points;
  /// Of each point its place in the whole input, in any order, no two the same. Equal points are one, for which the lowest
  /// index stands; all of them are given.
  std::span<const std::uint64_t> indices;
};

}  // namespace rbpa

// What:   defines rectangular regions of the plane, each of which owns a part of a complex, and the halo of a region,
//         whose points determine that part.
// Law:    disjoint regions own no item of the complex in common: a triangle belongs to the region that contains its
//         lexicographically least corner, an edge to the region that contains its lesser end, a vertex to the region
//         that contains it.
// Source: docs/explanation/plane.md, sections 18 to 22.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"

namespace rbpa {

/// The half-open box [x0, x1) × [y0, y1); by default the whole plane. Bounds may be infinite; the box is empty if
/// x0 = x1 or y0 = y1. −0 equals +0.
struct Region {
  double x0 = -std::numeric_limits<double>::infinity();
  double y0 = -std::numeric_limits<double>::infinity();
  double x1 = std::numeric_limits<double>::infinity();
  double y1 = std::numeric_limits<double>::infinity();

  /// Returns whether the box contains the point; false if a coordinate is not a number.
  bool contains(const Point& p) const { return x0 <= p.x && p.x < x1 && y0 <= p.y && p.y < y1; }
  friend bool operator==(const Region&, const Region&) = default;
};

/// Returns a box that contains every point at a distance of at most 2 alpha from a point of the region. The box is
/// rounded outward, and contains some points that are farther.
/// Throws: InvalidInput unless 0 < alpha < ∞, x0 ≤ x1 and y0 ≤ y1.
RBPA_API Region halo(const Region& region, double alpha);

/// The input of partial() (plane/partial.h) for a region: all points in halo(region, alpha). Further points of the
/// whole input are allowed.
struct RegionPoints {
  std::span<const Point> points;
  /// For each point its index in the whole input, in any order, none twice. Equal points count as one, under the lowest
  /// of their indices; all of them must be given.
  std::span<const std::uint64_t> indices;
};

}  // namespace rbpa

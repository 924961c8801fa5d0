// What: makes rings noded: a place is one point, and a vertex of any ring that lies on an edge is a vertex of that
//       edge's ring.
// Law:  the rings stay the same sets of the plane. Afterwards two edges that have more than an end in common cross in
//       their inner parts, or are the same edge.
// Cost: n log n in the vertices, and a visit of each box of a tree of points that a long slanted edge crosses.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

struct NodedRings {
  std::vector<Ring> rings;  ///< of the points at one place, only the least index is used
  /// For each edge of each ring, the edge of the input ring from which it comes.
  std::vector<std::vector<std::size_t>> edge_of;
};

/// Returns the noded rings. Of consecutive vertices at one place, one is kept.
/// Requires: rings that check_points() accepts.
/// Throws:   Cancelled.
NodedRings node(std::span<const Point> points, std::span<const Ring> rings, Steps& step);

}  // namespace rbpa

// What: makes rings noded: equal points become one index, and a vertex of any ring that lies on an edge becomes a
//       vertex of that edge's ring.
// Law:  the rings remain the same point sets of the plane. Two edges of noded rings are disjoint, have one end in
//       common, cross in their inner parts, or are the same edge.
// Cost: n log n in the vertices; for each edge, the boxes of a tree of the vertices that the edge crosses.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/plane/outline_polygons.h"

namespace rbpa {

struct NodedRings {
  std::vector<Ring> rings;  ///< equal points are represented by the least index
  /// For each edge of each ring, the number of the edge of the input ring that contains the edge.
  std::vector<std::vector<std::size_t>> edge_of;
};

/// Returns the noded rings. Keeps one of consecutive vertices with equal coordinates.
/// Requires: check_points() accepts the rings.
/// Throws:   Cancelled.
NodedRings node(std::span<const Point> points, std::span<const Ring> rings, Steps& step);

}  // namespace rbpa

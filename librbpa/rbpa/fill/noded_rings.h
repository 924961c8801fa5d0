// What:   rings in which a place is one point, and a vertex of any ring that lies on an edge is a vertex of that edge's ring.
// Law:    the rings are the same sets of the plane. Afterwards two edges that meet in more than an end cross in their inner
//         parts, or are the same edge.
// Cost:   n log n in the vertices, and what lies beside long slanted edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/steps.h"
#include "rbpa/shape.h"

namespace rbpa {

struct NodedRings {
  std::vector<Ring> rings;                        ///< of the first points at their places
  std::vector<std::vector<std::size_t>> edge_of;  ///< for each ring, of each of its edges: the edge of the input's ring
};

/// Of vertices that follow each other at one place one is kept.
/// Requires: check_points(). Throws: Cancelled.
NodedRings node(std::span<const Point> points, std::span<const Ring> rings, Steps& step);

}  // namespace rbpa

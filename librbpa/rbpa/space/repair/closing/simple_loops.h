// What: splits boundary loops into simple loops, which visit each point at most once.
// Law:  the points of the result are a function of the points along each loop, not of its first corner.
// Cost: n log n for a loop of n edges; quadratic at worst, if points repeat.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/progress.h"
#include "rbpa/base/point3.h"

namespace rbpa::space {

/// A corner of a loop: the vertex at which the edge before it ends, and the vertex at which the edge after it begins.
/// Where the two differ, they are at the same point.
struct LoopCorner {
  std::uint32_t in, out;
  std::uint32_t edge;  ///< number, in the given loop, of the edge after the corner
};

struct SimpleLoop {
  std::uint32_t loop;  ///< number of the given loop of which this one is a part
  std::vector<LoopCorner> corners;
};

/// Cuts each loop at points that it visits again. The part between two visits becomes a loop of its own, perhaps of
/// only two corners. Returns the simple loops, sorted by number of corners, then by their points. Throws: Cancelled.
std::vector<SimpleLoop> simple_loops(std::span<const Point3> points, std::span<const std::vector<std::uint32_t>> loops,
                                     meshops::Steps& step);

}  // namespace rbpa::space

// What: boundary loops as loops that come to no point twice.
// Law:  a function of the points along each loop, not of where it begins.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"

namespace rbpa::space {

/// A corner of a loop: the vertex at which the edge before ends and the one at which the edge behind begins. Where they differ,
/// they are at the same point.
struct LoopCorner {
  std::uint32_t in, out;
  std::uint32_t edge;  ///< behind it, by number in the whole loop
};

struct SimpleLoop {
  std::uint32_t loop;  ///< of which it is a part
  std::vector<LoopCorner> corners;
};

/// The loops, each cut at points to which it comes again: the part between becomes a loop of its own. Those of fewer corners
/// first, of equally many by their points.
std::vector<SimpleLoop> simple_loops(std::span<const Point3> points, std::span<const std::vector<std::uint32_t>> loops);

}  // namespace rbpa::space

// What: triangles with their neighbours in another order than that of their arrays.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

struct OrderedTriangles {
  std::vector<Triangle> triangles;
  std::vector<Triangle> neighbors;  ///< by their numbers in this order, or none
  operator TriangleArrays() const { return {triangles, neighbors}; }
};

/// Triangle i is number order[i] of the arrays. A pass in this order reads memory from end to end, and of two neighbours the
/// one with the smaller number comes first.
OrderedTriangles in_order(const TriangleArrays& arrays, const std::vector<std::uint32_t>& order);

/// Of each point, how many triangles are missing around it while there is none, with one for the boundary.
std::vector<std::uint32_t> gaps_of(const TriangleArrays& arrays, std::size_t points);

}  // namespace rbpa

// What: triangles with their neighbors in another order than that of their arrays.
#pragma once

#include <cstdint>
#include <vector>

#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// Triangle i is number order[i] of the arrays; neighbors are numbers in this order. A pass in it reads memory from end to end, and of two neighbors the
/// one with the smaller number comes first.
OwnedTriangles in_order(const TriangleArrays& arrays, const std::vector<std::uint32_t>& order);

/// Of each point, how many triangles are missing around it while there is none, with one for the boundary.
std::vector<std::uint32_t> gaps_of(const TriangleArrays& arrays, std::size_t points);

}  // namespace rbpa

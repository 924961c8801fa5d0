// What: puts triangles with their neighbors into another order, and counts the gaps around points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// Returns the triangles in a given order: triangle i is number order[i] of `arrays`, and neighbors are numbers in the
/// new order. A pass over the result reads memory sequentially. Requires: each triangle once in `order`. Cost: linear.
OwnedTriangles in_order(const TriangleArrays& arrays, std::span<const std::uint32_t> order);

/// Returns for each point the number of gaps around the point before any triangle is added: one for each triangle at
/// the point, and one for each fan of triangles there that ends at the boundary. Cost: linear.
std::vector<std::uint32_t> gaps_of(const TriangleArrays& arrays, std::size_t points);

}  // namespace rbpa

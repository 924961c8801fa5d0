// What: a view of triangles and their neighbors as two arrays, and the check that both agree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle.h"

namespace rbpa {

/// A view of triangles and neighbors, to which an AlphaComplex converts.
struct TriangleArrays {
  /// The value for no neighbor in `neighbors`.
  static constexpr std::uint32_t none = no_index;

  std::span<const Triangle> triangles;  ///< corners as indices of points, counter-clockwise
  /// For each triangle, entry k is the triangle across the side opposite its corner k, or none.
  std::span<const Triangle> neighbors;
};

/// Triangles and their neighbors. The view to which they convert is valid as long as this object is unchanged.
struct OwnedTriangles {
  std::vector<Triangle> triangles, neighbors;
  operator TriangleArrays() const { return {triangles, neighbors}; }
};

/// Checks that triangles and neighbors agree: each triangle has a row of neighbors, its corners are three different
/// numbers below `points`, and two neighbors name each other across the side that they share, in opposite directions.
/// Does not check whether triangles are counter-clockwise, or whether a neighbor is missing on both sides of an edge.
/// Throws: ContractViolation that names the first triangle with an error, or the numbers of rows; Cancelled.
/// Cost:   linear.
RBPA_API void require_linked(const TriangleArrays& arrays, std::size_t points, const GoOn& go_on = {});

}  // namespace rbpa

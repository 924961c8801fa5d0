// What: a view of triangles and their neighbors as two arrays, and a check that both arrays agree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/progress.h"
#include "rbpa/base/triangle.h"

namespace rbpa {

/// A view of triangles and their neighbors. An AlphaComplex converts to this type.
struct TriangleArrays {
  /// The value in `neighbors` that stands for no neighbor.
  static constexpr std::uint32_t none = no_index;

  std::span<const Triangle> triangles;  ///< corners as indices of points, counter-clockwise
  /// For each triangle, entry k is the index of the triangle across the side opposite corner k, or `none`.
  std::span<const Triangle> neighbors;
  /// Whether segments hold some sides in place, so that the triangulation has no natural neighbors.
  bool is_constrained = false;
};

/// Triangles and their neighbors, as an owner. Converts to a view, which is valid as long as this object is unchanged.
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

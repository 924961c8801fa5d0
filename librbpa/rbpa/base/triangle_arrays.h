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

  std::span<const Triangle> triangles;  ///< counter-clockwise
  /// For each triangle, entry k is the triangle across from its corner k, or none.
  std::span<const Triangle> neighbors;
};

/// Triangles and their neighbors, which convert to a view.
struct OwnedTriangles {
  std::vector<Triangle> triangles, neighbors;
  operator TriangleArrays() const { return {triangles, neighbors}; }
};

/// Checks that triangles and neighbors agree: there is a row of neighbors for each triangle, its corners are three
/// different numbers below `points`, and two neighbors name each other across the side that they share.
/// Throws: ContractViolation that names the first triangle with an error, or differing numbers of rows; Cancelled.
/// Cost:   linear.
RBPA_API void require_linked(const TriangleArrays& arrays, std::size_t points, const GoOn& go_on = {});

}  // namespace rbpa

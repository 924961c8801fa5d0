// What: a view of triangles and their neighbors, and the check that they agree.
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
  std::span<const Triangle> neighbors;  ///< number k is the triangle across from corner k, or none
};

/// Triangles and their neighbors, which convert to a view.
struct OwnedTriangles {
  std::vector<Triangle> triangles, neighbors;
  operator TriangleArrays() const { return {triangles, neighbors}; }
};

/// Checks that triangles and neighbors agree.
/// Requires: corners are three different numbers below `points`; neighbors are triangles, and each is the other's
///           neighbor across the side that they share.
/// Throws:   ContractViolation that names the first triangle that violates this; Cancelled.
/// Cost:     linear.
RBPA_API void require_linked(const TriangleArrays& arrays, std::size_t points, const GoOn& go_on = {});

}  // namespace rbpa

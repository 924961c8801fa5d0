// What: a view of triangles and their neighbors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/triangle.h"

namespace rbpa {

/// The triangles and neighbors of a Triangulation, which converts to this. Owns nothing.
struct TriangleArrays {
  /// In `neighbors`, stands for no neighbor.
  static constexpr std::uint32_t none = no_index;

  std::span<const Triangle> triangles;  ///< counter-clockwise
  std::span<const Triangle> neighbors;  ///< number k is the triangle across from corner k, or none
};

/// The same, owned.
struct OwnedTriangles {
  std::vector<Triangle> triangles, neighbors;
  operator TriangleArrays() const { return {triangles, neighbors}; }
};

/// Requires: corners are three different numbers below `points`; neighbors are triangles, and each is the other's
///           neighbor across the side that they share.
/// Throws:   ContractViolation that names the first triangle that violates this; Cancelled when `go_on`, which is called
///           every few milliseconds, returns false. Empty: never called.
/// Cost:     linear.
RBPA_API void require_linked(const TriangleArrays& arrays, std::size_t points, const std::function<bool()>& go_on = {});

}  // namespace rbpa

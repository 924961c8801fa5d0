// What: triangles and what lies across of each, wherever they are kept.
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

/// As a Triangulation with neighbours has them, and converts to. Nothing is owned.
struct TriangleArrays {
  /// What stands for a neighbour where there is none.
  static constexpr std::uint32_t none = no_index;

  std::span<const Triangle> triangles;  ///< counter-clockwise
  std::span<const Triangle> neighbors;  ///< number k is the triangle across from corner k, or none
};

/// The same, owned.
struct OwnedTriangles {
  std::vector<Triangle> triangles, neighbors;
  operator TriangleArrays() const { return {triangles, neighbors}; }
};

/// Requires: corners are three different numbers below `points`; neighbours are triangles and know each other by the side
///           that they share.
/// Throws:   ContractViolation that names the first triangle of which that is not so; Cancelled when `go_on`, which is called
///           every few milliseconds, returns false. Empty: never called.
/// Cost:     linear.
RBPA_API void require_linked(const TriangleArrays& arrays, std::size_t points, const std::function<bool()>& go_on = {});

}  // namespace rbpa

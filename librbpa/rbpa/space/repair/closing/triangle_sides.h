// What: finds the sides of triangles that are given by vertex numbers alone, and the loops of the triangles' boundary.
// Cost: a sort of the sides.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/progress.h"

namespace rbpa::space {

/// A side of a triangle, counter-clockwise, and the corner across from it.
struct TriangleSide {
  std::uint32_t from, to, across;
  std::uint32_t triangle;
};

/// Returns the sides of which both ends are wanted, or all sides if `is_wanted` is empty. Sorted by from, to, triangle.
/// Throws: Cancelled.
std::vector<TriangleSide> sorted_sides(std::span<const std::array<std::uint32_t, 3>> triangles,
                                       const std::vector<bool>& is_wanted, meshops::Steps& step);

/// Returns the loops that boundary_loops() returns. Throws: what boundary_loops() throws; Cancelled.
std::vector<std::vector<std::uint32_t>> loops_of(std::span<const std::array<std::uint32_t, 3>> triangles,
                                                 meshops::Steps& step);

/// The triangles at the edges of given boundary loops.
class BoundarySides {
 public:
  /// Finds the triangles. Throws: ContractViolation if a loop is empty or has an edge that is not a boundary side, or
  /// if the loops contain an edge twice; Cancelled.
  BoundarySides(std::span<const std::array<std::uint32_t, 3>> triangles,
                std::span<const std::vector<std::uint32_t>> loops, meshops::Steps& step);

  /// Returns the third corner of the triangle at an edge of a loop. Edge i leads from corner i of the loop to the next.
  std::uint32_t across(std::uint32_t loop, std::uint32_t edge) const { return across_[loop][edge]; }

 private:
  std::vector<std::vector<std::uint32_t>> across_;
};

}  // namespace rbpa::space

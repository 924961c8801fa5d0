// What: the voids of a solid: the bounded components of what is outside, each with its volume and what is around it.
// Law:  exact in what is a void and what bounds it; a function of the set of points and alpha, down to the last bit of the measures.
//       The volume is that within its boundary, less what floats in it, and needs no tetrahedra of a larger radius. docs/solid.md, section 8.
// Cost: that of count(), and the measures of the voids' boundary; where something floats in voids, a search among its pieces for each
//       triangle of a void around some.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/solid.h"
#include "rbpa/solid_boundary.h"
#include "rbpa/solid_topology.h"

namespace rbpa {

/// The kind of complex whose faces close a void.
enum class VoidWalls {
  solid,  ///< tetrahedra: voids() of solid()
  full    ///< and triangles that are in none: what a ball of radius alpha cannot leave; voids of the full alpha complex
};

struct SolidVoid {
  std::vector<std::uint32_t> triangles;  ///< of the boundary, that bound it, by number; ascending
  std::vector<std::uint32_t> points;     ///< their corners; ascending
  std::size_t islands = 0;               ///< pieces of the solid that float in it
  double volume = 0;  ///< of its tetrahedra, between the points; as accurate as measure() of a boundary
  /// The volume within it that is at least alpha from every point, where the center of a ball may be. Known of voids of
  /// the full complex.
  std::optional<double> outside_balls = {};
  double area = 0;   ///< of its triangles
  Point3 low, high;  ///< opposite corners of its box
};

struct Voids {
  /// Stands for the outside of everything.
  static constexpr std::uint32_t none = 0xffffffff;

  std::vector<SolidVoid>
      all;  ///< the largest volume first; of equal ones that with the lexicographically least triangle
  std::vector<std::uint32_t> number;  ///< of each triangle of the boundary: the void in `all` that it faces, or none
  SolidCounts counts;                 ///< of the solid: what count() returns
};

/// Requires: a solid of these points with neighbors, and its boundary.
/// Throws:   ContractViolation where they visibly are not.
RBPA_API Voids voids(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary);

}  // namespace rbpa

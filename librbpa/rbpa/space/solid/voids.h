// What: the voids of a solid: the bounded components of the complement, each with its volume and its walls.
// Law:  which regions are voids, and their boundary, are exact; a function of the set of points and alpha, down to the
//       last bit of the measures. The volume of a void is that within its boundary, minus the islands in it;
//       no tetrahedra of a larger radius are needed. docs/explanation/space.md, section 18.
// Cost: that of count(), and the measures of the voids' boundary; if voids contain islands, also a search among their
//       components for each triangle of such a void.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/complex_kind.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_topology.h"

namespace rbpa {

struct SolidVoid {
  std::vector<std::uint32_t> triangles;  ///< numbers of the boundary triangles that bound it; ascending
  std::vector<std::uint32_t> points;     ///< their corners; ascending
  std::size_t islands = 0;               ///< components of the solid that lie in it
  double volume = 0;  ///< of its tetrahedra, between the points; with the accuracy of measure() of a boundary
  /// The volume of the points in it that are at least alpha from every input point: the possible centers of a ball.
  /// Present for voids of the full complex.
  std::optional<double> outside_balls = {};
  double area = 0;   ///< of its triangles
  Point3 low, high;  ///< opposite corners of its box
};

struct Voids {
  /// The value for the outside in `number`.
  static constexpr std::uint32_t none = 0xffffffff;

  /// The voids, the largest volume first; of equal ones the one with the lexicographically least triangle first.
  std::vector<SolidVoid> all;
  std::vector<std::uint32_t> number;  ///< for each triangle of the boundary, the void in `all` that it faces, or none
  SolidCounts counts;                 ///< counts of the solid, as by count()
};

/// Finds the voids of a solid.
/// Requires: a solid of these points with neighbors, and its boundary.
/// Throws:   ContractViolation when they visibly are not.
RBPA_API Voids voids(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary);

}  // namespace rbpa

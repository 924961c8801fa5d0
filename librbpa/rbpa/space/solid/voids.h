// What: finds the voids of a solid: the bounded components of its complement, each with its volume and its walls.
// Law:  voids and their boundaries are exact; they and their measures, to the last bit, are a function of the set of
//       points and alpha. The volume of a void is the volume within its boundary, minus that of the islands in it. No
//       tetrahedra of a larger radius are needed. docs/explanation/space.md, section 18.
// Cost: that of count(), and of measure() for the triangles around voids; for each triangle of a void with islands,
//       also a search among the components of the solid.
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

/// A void with its measures, in units of the points.
struct SolidVoid {
  std::vector<std::uint32_t> triangles;  ///< numbers of the boundary triangles that face the void; ascending
  std::vector<std::uint32_t> points;     ///< corners of these triangles; ascending
  std::size_t islands = 0;               ///< components of the solid that lie in the void
  double volume = 0;  ///< volume within its triangles, islands excluded; as accurate as BoundaryMeasures::volume
  /// Volume of the part of the void that is at least alpha from every input point: the possible centers of a ball of
  /// radius alpha. Absent except for voids of the full complex.
  std::optional<double> outside_balls = {};
  double area = 0;   ///< area of its triangles, those of islands included
  Point3 low, high;  ///< least and greatest coordinates of its points
};

/// The voids of a solid, and the void at each boundary triangle.
struct Voids {
  /// The value in `number` for triangles that face the outside.
  static constexpr std::uint32_t none = 0xffffffff;

  /// The voids, the largest volume first; of equal volumes, the void with the lexicographically least triangle, by
  /// coordinates, first.
  std::vector<SolidVoid> all;
  /// For each boundary triangle, the position in `all` of the void that it faces; none: the outside.
  std::vector<std::uint32_t> number;
  SolidCounts counts;  ///< counts of the solid, as by count()
};

/// Finds the voids of a solid.
/// Requires: `solid` is a solid of `points` with neighbors, and `boundary` is solid_boundary(solid).
/// Throws:   ContractViolation as count() of these arguments (solid_topology.h).
RBPA_API Voids voids(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary);

}  // namespace rbpa

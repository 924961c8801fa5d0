// What: finds the voids of a solid: the bounded components of its complement, each with its volume and boundary.
// Law:  voids and their boundaries are exact. Voids, boundaries and every bit of the measures are functions of the set
//       of points and alpha. The volume of a void excludes the islands in the void. Tetrahedra outside of the solid are
//       not needed. docs/explanation/space.md, section 18.
// Cost: linear but for islands: for a void whose bounding box has components of the solid in it, each of the void's
//       triangles is compared with those whose ranges of y it meets, at worst with all.
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
  std::vector<std::uint32_t> triangles;  ///< indices of the boundary triangles that face the void; ascending
  std::vector<std::uint32_t> points;     ///< corners of these triangles; ascending
  std::size_t islands = 0;               ///< components of the solid that lie in the void
  double volume = 0;                     ///< volume without islands; as accurate as BoundaryMeasures::volume
  /// Volume of the part of the void that is at least alpha away from every point: of the places at which a ball of
  /// radius alpha can have its center and no point inside. Set by full_voids() only (balls/full_topology.h).
  std::optional<double> outside_balls = {};
  double area = 0;   ///< area of all `triangles`, which include those of islands
  Point3 low, high;  ///< opposite corners of the bounding box
};

/// The voids of a solid, and the void at each boundary triangle.
struct Voids {
  /// The value in `number` for triangles that face the outside.
  static constexpr std::uint32_t none = 0xffffffff;

  /// The voids by descending volume. Among equal volumes, the void with the lexicographically least triangle is first.
  std::vector<SolidVoid> all;
  /// For each boundary triangle, the index in `all` of the void that the triangle faces; none: the outside.
  std::vector<std::uint32_t> number;
  SolidCounts counts;  ///< the counts of the solid that count() returns
};

/// Finds the voids of a solid.
/// Requires: `solid` is a solid of `points` with neighbors, and `boundary` is solid_boundary(solid).
/// Throws:   ContractViolation in the cases in which count() throws (solid_topology.h).
RBPA_API Voids voids(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary);

}  // namespace rbpa

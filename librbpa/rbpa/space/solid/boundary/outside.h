// What: finds from the boundary of a solid which triangles bound the same component of the outside.
// Law:  a function of the tetrahedra; exact.
// How:  a regular neighborhood of the complex is bounded by closed surfaces, one for each component of the outside of a
//       connected complex (Alexander duality). One surface follows triangles that are glued through the outside; at a
//       point it follows all fans in one region of the complement of the point's link. docs/explanation/space.md,
//       section 19.
// Cost: linear; where several fans meet at a point, linear in all tetrahedra around the point.
#pragma once

#include <cstddef>
#include <span>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"
#include "rbpa/space/solid/solid_topology.h"

namespace rbpa::space {

struct Outside {
  /// Sets of boundary triangles. Two triangles are in one set if their tetrahedra are in one component of the complex,
  /// and both triangles bound the same component of the complement of this component.
  meshops::DisjointSets surfaces;
  /// Sets of tetrahedra that are connected through points, edges or faces.
  meshops::DisjointSets components;
  /// Sets of tetrahedra that are connected through faces.
  meshops::DisjointSets solid_components;

  // Numbers of points and edges of the boundary.
  std::size_t points = 0, edges = 0;
  /// Twice the Euler characteristic of the complex; odd only if the boundary does not belong to the solid.
  std::ptrdiff_t twice_euler = 0;
};

/// Returns the components of the outside, and the counts.
/// Requires: `solid` is a solid of `points` with neighbors, and `boundary` is its boundary.
/// Throws:   ContractViolation where the solid and the boundary visibly do not belong together.
Outside outside_of(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary);

/// Returns the numbers of simplices and the Betti numbers of a solid. Cost: linear.
/// Requires: `outside` is the result of outside_of() for `solid` and `boundary`.
/// Throws:   ContractViolation when the counts are impossible: then the three arguments do not belong together.
SolidCounts count_solid(const Solid& solid, const SolidBoundary& boundary, const Outside& outside);

}  // namespace rbpa::space

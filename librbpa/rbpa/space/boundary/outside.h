// What: what is outside of a solid, known from its boundary: which triangles bound the same part of it, and counts.
// Law:  a function of the tetrahedra; exact.
// How:  a regular neighborhood of the complex is bounded by closed surfaces, one for each component of what is outside of a connected complex
//       (Alexander duality). Such a surface runs along triangles glued through the outside, and around a point in all fans that are
//       in the same region of its link's complement. docs/solid.md, section 9.
// Cost: linear; where several fans meet at a point, that of passing all tetrahedra around it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/solid.h"
#include "rbpa/solid_boundary.h"

namespace rbpa::space {

struct Outside {
  /// Of the boundary's triangles, those that bound the same component of what is outside of their own component of the complex.
  meshops::DisjointSets surfaces;
  /// Of tetrahedra, those that are connected, through points as well.
  meshops::DisjointSets components;
  /// Of tetrahedra, those that are connected through faces.
  meshops::DisjointSets solid_components;

  // Of the boundary.
  std::size_t points = 0, edges = 0;
  /// Twice the Euler characteristic of the complex.
  std::ptrdiff_t twice_euler = 0;
};

/// Requires: a solid of these points with neighbors, and its boundary.
/// Throws:   ContractViolation where they visibly are not.
Outside outside_of(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary);

}  // namespace rbpa::space

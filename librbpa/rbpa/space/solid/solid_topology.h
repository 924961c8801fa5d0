// What: counts the simplices, components, tunnels and voids of a solid.
// Law:  components − tunnels + voids = points − edges + triangles − tetrahedra, the Euler characteristic. Counts are
//       exact functions of the set of points and alpha. docs/explanation/space.md, section 18.
// Cost: union–find over the tetrahedra; the rest is linear in the boundary triangles, and in the tetrahedra around
//       points where the boundary touches itself.
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/solid_boundary.h"

namespace rbpa {

/// Counts of the union of the tetrahedra. Points in no tetrahedron are not counted.
struct SolidCounts {
  std::size_t points = 0;  ///< distinct points that are corners
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t tetrahedra = 0;
  std::size_t boundary_triangles = 0;  ///< triangles with a tetrahedron on one side only
  std::size_t solid_components = 0;    ///< components connected through triangles
  std::size_t components = 0;          ///< components connected through points: b₀
  std::size_t tunnels = 0;             ///< number of independent tunnels: b₁
  std::size_t voids = 0;               ///< bounded components of the complement: b₂
  friend bool operator==(const SolidCounts&, const SolidCounts&) = default;
};

/// Counts the simplices and the Betti numbers of a solid.
/// Requires: `solid` is a solid of `points` with neighbors, and `boundary` is solid_boundary(solid).
/// Throws:   ContractViolation when neighbors are missing, an index does not exist, the boundary is open, or the counts
///           are impossible, as with the boundary of another solid.
RBPA_API SolidCounts count(std::span<const Point3> points, const Solid& solid, const SolidBoundary& boundary);

}  // namespace rbpa

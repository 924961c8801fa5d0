// What: counts of a solid alpha complex as a topological space: its simplices, components and holes.
// Law:  components − holes = points − edges + triangles (the Euler characteristic; in the plane b₂ = 0).
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/alpha_complex.h"

namespace rbpa {

struct SolidAlphaComplex;  // rbpa/plane/complex.h

/// Counts of a complex. Triangles of a solid component are connected through edges; components are connected through
/// points as well, as at pinches.
struct ComplexCounts {
  std::size_t points_covered = 0;  ///< distinct input points in triangles: the vertices of the space
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t boundary_curves = 0;  ///< boundary curves; at a pinch, a curve continues along the same fan of triangles
  std::size_t solid_components = 0;
  std::size_t components = 0;
  std::size_t holes = 0;
  friend bool operator==(const ComplexCounts&, const ComplexCounts&) = default;
};

/// Counts the simplices and components of a complex.
/// Cost: about linear.
RBPA_API ComplexCounts count(const SolidAlphaComplex& complex);

/// Counts the same for a complex in arrays, from `boundary` if that was computed, otherwise from `neighbors`.
/// AlphaComplexOptions::boundary alone costs least.
///
/// With ComplexKind::full, edges in no triangle count as well, `points_covered` counts points in a triangle or an edge,
/// every other distinct point is a component, and components − holes = distinct points − edges + triangles.
/// Requires: a complex on these points, whose boundary or neighbors were computed.
/// Throws:   ContractViolation when neither was computed, or when boundary sides do not form closed curves; Cancelled.
/// Cost:     that of sorting the boundary; by neighbors, linear in the triangles.
RBPA_API ComplexCounts count(std::span<const Point> points, const AlphaComplex& complex,
                             ComplexKind kind = ComplexKind::solid, const GoOn& go_on = {});

}  // namespace rbpa

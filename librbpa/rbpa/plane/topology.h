// What: counts the simplices, components and holes of an alpha complex as a topological space.
// Law:  components − holes = points_covered − edges + triangles (the Euler characteristic; in the plane b₂ = 0).
#pragma once

#include <cstddef>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point.h"
#include "rbpa/plane/alpha_complex.h"

namespace rbpa {

struct SolidAlphaComplex;  // rbpa/plane/complex.h

/// Counts of a complex.
struct ComplexCounts {
  std::size_t points_covered = 0;  ///< distinct input points in triangles: the vertices of the space
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t boundary_curves = 0;   ///< closed curves of boundary edges; at a pinch, a curve follows one fan
  std::size_t solid_components = 0;  ///< components of the triangles, connected through edges
  std::size_t components = 0;        ///< components connected through points: pinches connect
  std::size_t holes = 0;             ///< bounded components of the complement in the plane
  friend bool operator==(const ComplexCounts&, const ComplexCounts&) = default;
};

/// Counts the simplices, components and holes of a complex that rbpa() or hrbpa() returned.
/// Cost: about linear.
RBPA_API ComplexCounts count(const SolidAlphaComplex& complex);

/// Counts the simplices, components and holes of a complex in arrays, from its boundary if that was computed, otherwise
/// from its neighbors. A complex that was computed with its boundary alone costs least.
///
/// With ComplexKind::full, edges in no triangle count as well, `points_covered` counts points in a triangle or an edge,
/// every other distinct point is a component, and components − holes = distinct points − edges + triangles.
/// Requires: a complex of these points as alpha_complex() returns it, with boundary or neighbors; full if `kind` is.
/// Throws:   ContractViolation when neither boundary nor neighbors were computed, or when boundary sides do not form
///           closed curves; Cancelled.
/// Cost:     that of sorting the boundary; by neighbors, linear in the triangles.
RBPA_API ComplexCounts count(std::span<const Point> points, const AlphaComplex& complex,
                             ComplexKind kind = ComplexKind::solid, const GoOn& go_on = {});

}  // namespace rbpa

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

/// Counts of a complex. Solid components are connected through edges, and are the components of the mesh; components of
/// the space are connected through pinches as well.
struct ComplexCounts {
  std::size_t points_covered = 0;  ///< distinct input points in triangles: the vertices of the space
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t boundary_curves = 0;  ///< boundary curves of the mesh, where a curve does not pass through a pinch
  std::size_t solid_components = 0;
  std::size_t components = 0;
  std::size_t holes = 0;
  friend bool operator==(const ComplexCounts&, const ComplexCounts&) = default;
};

/// Counts the simplices and components of a complex.
/// Cost: about linear.
RBPA_API ComplexCounts count(const SolidAlphaComplex& complex);

/// Counts the same in arrays: by their boundary if it was computed, otherwise by the neighbors. Nothing else is read,
/// since in the plane curves around components have the opposite direction of curves around holes. So `.boundary` alone
/// costs least.
///
/// In a full complex, edges in no triangle are counted as well. The points covered are those in a triangle or an edge,
/// every other distinct point is a component, and components − holes = distinct points − edges + triangles.
/// Requires: triangles that lie side by side, on these points.
/// Throws:   ContractViolation when their sides are visibly the boundary of nothing; Cancelled.
/// Cost:     that of sorting the boundary; by neighbors, linear in the triangles.
RBPA_API ComplexCounts count(std::span<const Point> points, const AlphaComplex& complex,
                             ComplexKind kind = ComplexKind::solid, const GoOn& go_on = {});

}  // namespace rbpa

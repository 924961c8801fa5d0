// What: the counts of a solid alpha complex as a topological space.
// Law:  components − holes = points − edges + triangles (the Euler characteristic; in the plane b₂ = 0).
#pragma once

#include <cstddef>

#include "rbpa/base/api.h"

namespace rbpa {

struct SolidAlphaComplex;  // rbpa/complex.h

/// Components are counted in two ways: solid ones are connected through edges, and are the components of the mesh; those of
/// the space are connected through pinches as well.
struct ComplexCounts {
  std::size_t points_covered = 0;  ///< distinct input points in triangles: the vertices of the space
  std::size_t edges = 0;
  std::size_t triangles = 0;
  std::size_t boundary_curves = 0;  ///< of the mesh: a curve does not pass through a pinch
  std::size_t solid_components = 0;
  std::size_t components = 0;
  std::size_t holes = 0;
  friend bool operator==(const ComplexCounts&, const ComplexCounts&) = default;
};

/// Cost: about linear.
RBPA_API ComplexCounts count(const SolidAlphaComplex& complex);

}  // namespace rbpa

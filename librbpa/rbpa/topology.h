// What: how many of everything a solid alpha complex has, as a space.
// Law:  components − holes = points − edges + triangles (the Euler characteristic; in the plane b₂ = 0).
#pragma once

#include <cstddef>

#include "rbpa/base/api.h"

namespace rbpa {

struct SolidAlphaComplex;  // rbpa/complex.h

/// Two ways to count components: solid ones hang together through edges, and are the components of the mesh; pinches
/// join those of the space.
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

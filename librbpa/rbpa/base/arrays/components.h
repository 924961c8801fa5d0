// What: the solid components of a complex: triangles connected through edges.
#pragma once

#include <cstdint>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// Returns the solid components of a complex as sets of triangles.
/// Requires: `complex` has neighbors. Throws: Cancelled.
inline meshops::DisjointSets components_of(const TriangleArrays& complex, Steps& step) {
  const auto triangles = static_cast<std::uint32_t>(complex.triangles.size());
  meshops::DisjointSets components(triangles);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    step();
    for (const std::uint32_t other : complex.neighbors[t])
      if (other < t) components.unite(t, other);
  }
  return components;
}

}  // namespace rbpa

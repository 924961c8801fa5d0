// What: the fans of triangles around points: triangles at one point that are linked around it form a fan.
#pragma once

#include <algorithm>
#include <cstdint>

#include "meshops/core/disjoint_sets.h"
#include "rbpa/base/run/steps.h"
#include "rbpa/base/triangle_arrays.h"

namespace rbpa {

/// Returns the fans as sets of corners; corner k of triangle t is 3t + k.
/// Requires: require_linked() accepts `arrays`; not checked.
/// Throws:   Cancelled.
/// Cost:     linear.
inline meshops::DisjointSets fans_of(const TriangleArrays& arrays, Steps& step) {
  meshops::DisjointSets fans(3 * arrays.triangles.size());
  const auto corner_at = [&](std::uint32_t triangle, std::uint32_t point) {
    const Triangle& corners = arrays.triangles[triangle];
    const auto k = std::find(corners.begin(), corners.end(), point) - corners.begin();
    return 3 * triangle + static_cast<std::uint32_t>(k);
  };
  for (std::uint32_t t = 0; t < arrays.triangles.size(); ++t) {
    step();
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t other = arrays.neighbors[t][k];
      if (other == TriangleArrays::none || other < t) continue;
      for (const std::uint32_t end : {(k + 1) % 3, (k + 2) % 3})
        fans.join(3 * t + end, corner_at(other, arrays.triangles[t][end]));
    }
  }
  return fans;
}

}  // namespace rbpa

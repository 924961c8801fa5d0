// What: faces as lists of points, as files store them, without adjacency.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/core/api.h"

namespace meshops {

/// Soup of polygons. Points are numbers from 0; a face is the cycle of its corners, which are points. A cycle may have
/// any length, also 0, and corners that are out of range or repeated. `begin` must split `corners` into faces. Every
/// function that reads a soup checks this (require_parted()); the members check nothing.
struct PolygonSoup {
  std::size_t points = 0;                ///< number of points, including points without a face
  std::vector<std::uint32_t> corners;    ///< corners of all faces, one face after the other
  std::vector<std::size_t> begin = {0};  ///< for each face, the index of its first corner; then corners.size()

  std::size_t faces() const { return begin.size() - 1; }
  /// Returns the corners of face f. Requires: f < faces(); not checked.
  std::span<const std::uint32_t> face(std::size_t f) const {
    return std::span(corners).subspan(begin[f], begin[f + 1] - begin[f]);
  }
  /// Adds a face at the end.
  void add_face(std::span<const std::uint32_t> cycle) {
    corners.insert(corners.end(), cycle.begin(), cycle.end());
    begin.push_back(corners.size());
  }
};

/// Throws ContractViolation, which describes the place, unless `begin` splits `corners` into faces: `begin` starts with
/// 0, never decreases, and ends with the number of corners. Cost: linear in the faces; no corner is read.
MESHOPS_API void require_parted(const PolygonSoup& soup);

}  // namespace meshops

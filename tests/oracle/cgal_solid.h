// What: checks with CGAL's Polygon Mesh Processing whether the mesh of a file is a solid.
#pragma once

#include <cstddef>
#include <string>

namespace rbpa_test {

struct CgalSolid {
  std::size_t faces = 0;
  bool closed = false;  ///< there is no border
  /// Two faces share more than a vertex or an edge; vertices at one place count as a crossing.
  bool crosses_itself = false;
  /// Faces are oriented so that each component bounds a volume from the right side; false if one is open.
  bool bounds_a_volume = false;
};

/// Reads an OFF file, without any repair. Throws std::runtime_error when its faces are not an oriented manifold.
CgalSolid cgal_solid(const std::string& path);

}  // namespace rbpa_test

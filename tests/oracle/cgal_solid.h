// What: whether CGAL's Polygon Mesh Processing finds the mesh of a file to be a solid.
#pragma once

#include <cstddef>
#include <string>

namespace rbpa_test {

struct CgalSolid {
  std::size_t faces = 0;
  bool closed = false;          ///< no border
  bool crosses_itself = false;  ///< two faces have more in common than a vertex or an edge; vertices at one place cross
  bool bounds_a_volume =
      false;  ///< faces are oriented so that each component bounds it from the right side; false where it is open
};

/// An OFF file, without anything repaired. Throws std::runtime_error when its faces are no oriented manifold.
CgalSolid cgal_solid(const std::string& path);

}  // namespace rbpa_test

// What: the two kinds of alpha complex, solid and full.
#pragma once

namespace rbpa {

/// The simplices that belong to an alpha complex of radius alpha.
enum class ComplexKind {
  /// Delaunay triangles of circumradius ≤ alpha (in space: tetrahedra), with their edges and corners.
  solid,
  /// Moreover every simplex whose corners an otherwise empty ball of radius alpha can touch: edges and points in no
  /// triangle, triangles in no tetrahedron.
  full
};

}  // namespace rbpa

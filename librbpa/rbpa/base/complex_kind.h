// What: the two kinds of alpha complex, solid and full.
#pragma once

namespace rbpa {

/// The simplices that belong to an alpha complex of radius alpha.
enum class ComplexKind {
  /// Delaunay triangles of circumradius ≤ alpha (in space: tetrahedra), with their edges and corners.
  solid,
  /// The solid complex, and the dangling simplices: edges and points in no triangle of it (in space: also triangles in
  /// no tetrahedron) whose corners lie on the boundary of a ball of radius alpha with no point inside.
  full
};

}  // namespace rbpa

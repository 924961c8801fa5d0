// What: the two kinds of alpha complex, solid and full.
#pragma once

namespace rbpa {

/// The kind of an alpha complex of radius alpha, which decides about the simplices in it.
enum class ComplexKind {
  /// Delaunay triangles of circumradius ≤ alpha (in space: tetrahedra), with their edges and corners.
  solid,
  /// The solid complex, and the dangling simplices: edges and points in no triangle of the solid complex (in space: and
  /// triangles in no tetrahedron) whose corners lie on the boundary of a ball of radius alpha with no point inside.
  full
};

}  // namespace rbpa

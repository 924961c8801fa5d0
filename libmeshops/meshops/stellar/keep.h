// What: the property that a stellar operator must keep: the mesh stays simplicial, or it only stays a manifold.
// Law:  with either choice, a sound mesh stays sound (core/validate.h).
#pragma once

namespace meshops {

/// Property that an operator keeps. The operator refuses a change that would break the property.
enum class Keep {
  /// A manifold in which no two edges join the same vertices, and no two triangles have the same corners. If the mesh
  /// already has edges or triangles of this kind, an operator may leave or move some of them without a refusal.
  simplicial,
  /// A manifold: no edge has one vertex at both ends, no edge is without a face, and the faces at each vertex form one
  /// fan. Two edges may join the same vertices, and two triangles may share two or three edges.
  manifold
};

}  // namespace meshops

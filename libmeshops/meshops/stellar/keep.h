// What: what a stellar operator must keep of a mesh, beyond what it always keeps.
// Law:  whatever the choice, a sound mesh stays sound (core/validate.h).
#pragma once

namespace meshops {

enum class Keep {
  /// A simplicial mesh stays one: refused is what would make two edges join the same vertices, or two triangles have the
  /// same corners. On a mesh with such edges, those that an operator touches count as if it made them.
  simplicial,
  /// Refused is only what would leave no manifold: a loop edge, an edge without a face, a pinch. Two edges may join the
  /// same vertices, and two triangles may share two or three edges.
  manifold
};

}  // namespace meshops

// What: the choice between simplicial and manifold: the property that a stellar operator must keep.
// Law:  with either choice, a sound mesh stays sound (core/validate.h).
#pragma once

namespace meshops {

enum class Keep {
  /// A simplicial mesh stays simplicial: refuses a change after which two edges would join the same vertices, or two
  /// triangles would have the same corners. If the mesh has such edges already, those that an operator touches count as
  /// if the operator made them.
  simplicial,
  /// Refuses only a change that would leave no manifold: a loop edge, an edge without a face, a pinch. Two edges may
  /// join the same vertices, and two triangles may share two or three edges.
  manifold
};

}  // namespace meshops

// What: a patch: triangles that were found together, with their adjacency; the input of PatchAssembler.
#pragma once

#include <array>
#include <vector>

#include "meshops/patch/site.h"

namespace meshops {

/// Triangles of a complex. Side i of a triangle runs from its corner i to corner i + 1, modulo 3. The number of the
/// side in the patch is 3 · triangle + i.
struct Patch {
  /// A triangle of another patch may lie across the side. If none does, the boundary halfedge is active in a Front.
  static constexpr int open = -1;
  static constexpr int nothing = -2;  ///< no patch has a triangle across the side; a Front freezes the side

  std::vector<std::array<Site, 3>> triangles;  ///< the corners of each triangle, counter-clockwise
  /// For each triangle and each of its sides: the number of the side of another triangle of the patch across the edge,
  /// whose entry must lead back, or `open` or `nothing`. survey() checks this.
  std::vector<std::array<int, 3>> across;

  void clear() {
    triangles.clear();
    across.clear();
  }
};

}  // namespace meshops

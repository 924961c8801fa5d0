// What: the sides and sites of a patch that connect it to the mesh around it, as indices into the patch alone.
// Why:  only the rim of a patch depends on other patches; the code that made the patch often knows its rim, and need
//       not search for it again.
#pragma once

#include <vector>

#include "meshops/core/api.h"
#include "meshops/patch/patch.h"

namespace meshops {

struct Outline {
  std::vector<int> rim;    ///< sides across which no triangle of the patch lies but one of another patch may; ascending
  std::vector<int> holes;  ///< sides beyond which nothing lies; ascending
  /// For each entry of `holes`, the hole whose boundary halfedge follows the boundary halfedge of this hole, as a side,
  /// or −1 where the next boundary halfedge depends on another patch.
  std::vector<int> next_hole;
  /// One side for each inner site, around which triangles of the patch close, in any order: the greatest of the sides
  /// that leave the site and have a lower number than the side across.
  std::vector<int> inside;

  void clear() {
    rim.clear();
    holes.clear();
    next_hole.clear();
    inside.clear();
  }
};

/// Computes the outline of a patch and writes it to `outline`.
/// Requires: `across` has an entry for each triangle and is symmetric: a side across which side j lies is itself across
///           side j.
/// Throws:   ContractViolation; `outline` is then empty or unchanged. Cost: linear in the patch.
MESHOPS_API void survey(const Patch& patch, Outline& outline);

/// Returns the entry of Outline::next_hole for the hole at side `hole`, for a caller that knows the holes.
/// Requires: as survey(), but not checked. Cost: linear in the triangles between the two holes.
MESHOPS_API int next_hole(const Patch& patch, int hole);

}  // namespace meshops

// What: the sides and sites of a patch that connect it to the mesh around it, as indices into the patch alone.
// Why:  only the rim of a patch depends on other patches; the code that made a patch often knows the rim already.
#pragma once

#include <vector>

#include "meshops/core/api.h"
#include "meshops/patch/patch.h"

namespace meshops {

/// Outline of a patch. A side is given by its number in the patch.
struct Outline {
  std::vector<int> rim;    ///< sides across which only a triangle of another patch may lie; ascending
  std::vector<int> holes;  ///< sides across which no patch has a triangle; ascending
  /// For each entry of `holes`, the entry whose boundary halfedge follows that of the hole along the boundary; −1 if
  /// the next boundary halfedge depends on another patch.
  std::vector<int> next_hole;
  /// For each inner site (a site around which triangles of the patch close), one side, in any order of the sites. Among
  /// the sides that leave the site and have a lower number than the side across them, it is the greatest.
  std::vector<int> inside;

  void clear() {
    rim.clear();
    holes.clear();
    next_hole.clear();
    inside.clear();
  }
};

/// Computes the outline of a patch, and writes it to `outline`.
/// Requires: `across` has an entry for each triangle and is symmetric: if side j lies across side i, then i lies across
///           j, and both are sides of different triangles. Throws ContractViolation; `outline` is then unchanged or
///           incomplete. Not checked: sides across each other run between the same sites.
/// Cost:     linear in the patch.
MESHOPS_API void survey(const Patch& patch, Outline& outline);

/// Returns the entry of Outline::next_hole for the side `hole`, for a caller that finds the holes without survey().
/// Requires: nothing lies across `hole`, and `across` is as for survey(). Not checked.
/// Cost:     linear in the triangles around the start of `hole`.
MESHOPS_API int next_hole(const Patch& patch, int hole);

}  // namespace meshops

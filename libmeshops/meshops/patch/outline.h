// What: the sides and sites of a patch that connect it to the mesh around it, as indices into the patch alone.
// Why:  only the rim of a patch depends on other patches; the code that made the patch often knows its rim, and need
//       not search for it again.
#pragma once

#include <vector>

#include "meshops/core/api.h"
#include "meshops/patch/patch.h"

namespace meshops {

/// Outline of a patch. A side is given by its number in the patch.
struct Outline {
  std::vector<int> rim;    ///< sides across which no triangle of the patch lies but one of another patch may; ascending
  std::vector<int> holes;  ///< sides beyond which nothing lies; ascending
  /// For each entry of `holes`: the side whose boundary halfedge follows that of the hole, itself an entry of `holes`;
  /// or −1 where the next boundary halfedge depends on another patch.
  std::vector<int> next_hole;
  /// One side for each inner site (a site around which triangles of the patch close), in any order: of the sides that
  /// leave the site and have a lower number than the side across them, the greatest.
  std::vector<int> inside;

  void clear() {
    rim.clear();
    holes.clear();
    next_hole.clear();
    inside.clear();
  }
};

/// Computes the outline of a patch and writes it to `outline`.
/// Requires: `across` has an entry for each triangle and is symmetric: if side j lies across side i, then i lies across
///           j, and the two are sides of different triangles. Throws ContractViolation; `outline` is then empty or
///           unchanged. Not checked: that sides across each other run between the same sites.
/// Cost:     linear in the patch.
MESHOPS_API void survey(const Patch& patch, Outline& outline);

/// Returns the entry of Outline::next_hole for the side `hole`, for a caller that knows the holes.
/// Requires: nothing lies across `hole`, and `across` is as for survey(). Not checked.
/// Cost:     linear in the triangles around the start of `hole`.
MESHOPS_API int next_hole(const Patch& patch, int hole);

}  // namespace meshops

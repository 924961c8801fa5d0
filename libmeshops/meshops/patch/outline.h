// What: the sides and sites of a patch that connect it to the mesh around it, in terms of the patch alone.
// Why:  only the rim of a patch depends on other patches; the code that made the patch often has it, and need not search again.
#pragma once

#include <vector>

#include "meshops/core/api.h"
#include "meshops/patch/patch.h"

namespace meshops {

struct Outline {
  std::vector<int> rim;    ///< the sides at which nothing of the patch lies, but of another may; ascending
  std::vector<int> holes;  ///< the sides beyond which there is nothing, ascending
  /// Of each hole, that whose boundary halfedge follows that of the hole, or −1 where another patch decides it.
  std::vector<int> next_hole;
  /// For each site inside, around which triangles of the patch close, a side out of it: the last of those whose number is
  /// less than that of the side across. In any order.
  std::vector<int> inside;

  void clear() {
    rim.clear();
    holes.clear();
    next_hole.clear();
    inside.clear();
  }
};

/// Replaces `outline` by that of the patch.
/// Requires: `across` for each triangle, of each side a side that is across of it in turn, or none.
/// Throws:   ContractViolation. Cost: linear in the patch.
MESHOPS_API void survey(const Patch& patch, Outline& outline);

/// An entry of Outline::next_hole, for a caller that has the holes. Requires what survey() does. Cost: linear in the triangles
/// between the two.
MESHOPS_API int next_hole(const Patch& patch, int hole);

}  // namespace meshops

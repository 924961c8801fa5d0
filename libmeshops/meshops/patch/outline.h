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
  /// For each hole, the hole whose boundary halfedge follows its own, or −1 where another patch decides it.
  std::vector<int> next_hole;
  /// For each inner site, around which triangles of the patch close, one side that leaves it: the last of those whose
  /// number is less than that of the side across. In any order.
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
/// Throws:   ContractViolation. Cost: linear in the patch.
MESHOPS_API void survey(const Patch& patch, Outline& outline);

/// Returns the entry of Outline::next_hole for a hole, for a caller that knows the holes. Requires: as survey(). Cost:
/// linear in the triangles between the two holes.
MESHOPS_API int next_hole(const Patch& patch, int hole);

}  // namespace meshops

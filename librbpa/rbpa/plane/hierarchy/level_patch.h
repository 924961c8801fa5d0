// What: splits the triangles of a patch by level: those of the first level become a patch of their own, the others
//       wait.
// Law:  the level of each triangle is the first whose radius admits it.
// Cost: a comparison of the circumradius for each triangle; if some triangles of the patch wait, a copy of the others.
#pragma once

#include <array>
#include <vector>

#include "meshops/patch/patch.h"
#include "rbpa/plane/hierarchy/site_levels.h"

namespace rbpa {

/// A triangle that is not of the first level.
struct WaitingTriangle {
  std::array<meshops::Site, 3> corners;
  int level;
};

struct LevelPatch {
  /// The triangles of the first level, in the order of the patch. Patch::nothing is across a side whose neighbor waits.
  meshops::Patch first;
  std::vector<WaitingTriangle> later;  ///< the other triangles, in the order of the patch
  /// For each triangle of the patch, the number of its first side in `first`; negative if the triangle waits.
  std::vector<int> number;

  /// Replaces all members. `first` stays empty if no triangle waits: it would equal `patch`.
  /// Requires: triangles within the last radius of the ladder.
  void split(const meshops::Patch& patch, const SiteLevels& levels);
};

}  // namespace rbpa

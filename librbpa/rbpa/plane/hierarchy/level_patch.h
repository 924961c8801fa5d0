// What:   triangles parted by level: those of the first as a patch of their own, the others to wait for theirs.
// Law:    each triangle is of the first level whose radius admits it.
// Cost:   a comparison of the circumradius for each triangle; where some of the patch wait, a copy of the others.
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
  meshops::Patch first;  ///< both in the order of the patch that was parted
  std::vector<WaitingTriangle> later;
  std::vector<int> number;  ///< of its triangles, that of the first side in `first`; negative where they wait

  /// Replaces all; `first` is not made when no triangle waits, as it is the patch itself then.
  /// Requires: triangles within the last radius of the ladder.
  void part(const meshops::Patch& patch, const SiteLevels& levels);
};

}  // namespace rbpa

// What:   triangles parted by level: those of the first as a patch of their own, the others to wait for theirs.
// Law:    each triangle is of the first level whose radius admits it.
// Cost:   a comparison of the circumradius for each triangle; where some of the patch wait, a copy of it.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "meshops/patch/patch.h"
#include "rbpa/core/point.h"
#include "rbpa/hierarchy/ladder.h"
#include "rbpa/search/sites.h"

namespace rbpa {

/// A triangle that is not of the first level.
struct WaitingTriangle {
  std::array<meshops::Site, 3> corners;
  int level;
};

struct LevelPatch {
  meshops::Patch first;                ///< in any order
  std::vector<WaitingTriangle> later;  ///< in the order of the patch that was parted
  std::vector<std::size_t> waiting;    ///< their numbers there

  /// Replaces all; `first` is not made when no triangle waits, as it is the patch itself then. The corners are in the
  /// window, scaled as the ladder is.
  /// Requires: triangles within the last radius of the ladder.
  void part(const meshops::Patch& patch, std::span<const Point> points, const ScaledLadder& ladder);
  /// The same of triangles on any sites.
  void part(const meshops::Patch& patch, const Sites& sites, const Ladder& ladder);

 private:
  template <typename LevelOf>
  void part(const meshops::Patch& patch, LevelOf level_of);
};

}  // namespace rbpa

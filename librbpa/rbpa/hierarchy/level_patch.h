// What:   triangles parted by level: those of the first as a patch of their own, the others to wait for theirs.
// Law:    level_of() is the first level whose radius admits the triangle.
// Cost:   for a triangle of the first level, one comparison of its circumradius.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meshops/front/patch.h"
#include "rbpa/core/point.h"
#include "rbpa/hierarchy/ladder.h"

namespace rbpa {

/// A triangle that is not of the first level.
struct WaitingTriangle {
  std::array<meshops::Site, 3> corners;
  std::int32_t level;
};

/// What a patch has on the first level, and later.
struct LevelPatch {
  meshops::Patch first;
  std::vector<WaitingTriangle> later;  ///< in the order of the patch
  std::vector<int> number;             ///< of each triangle of the patch, its first side in `first`, or that it waits

  /// Replaces all. Requires: triangles of the complex of the ladder's last radius.
  void part(const meshops::Patch& patch, std::span<const Point> points, const Ladder<double>& ladder);
};

/// The first level whose radius admits the triangle. Requires that the last one's does.
int level_of(const Point& a, const Point& b, const Point& c, const Ladder<double>& ladder);

}  // namespace rbpa

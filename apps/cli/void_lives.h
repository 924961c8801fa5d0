// What: at which radii voids of a solid close and are filled; and pockets, which close only above its radius.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"
#include "rbpa/solid_filtration.h"
#include "rbpa/surface.h"
#include "rbpa/void_tree.h"
#include "rbpa/voids.h"

namespace rbpa::app {

struct VoidLife {
  double closes = 0, filled = 0;  ///< a void for closes ≤ alpha < filled
  std::size_t depth = 0;          ///< how many voids it was parted from, one after the other
};

struct Pocket {
  VoidLife life = {};
  double volume = 0;                        ///< when it closes
  std::array<std::uint32_t, 3> mouth = {};  ///< points of the triangle that closes it
};

class VoidLives {
 public:
  /// Triangulates all points. Keeps a reference to them. Throws InvalidInput; Cancelled after a signal.
  VoidLives(std::span<const Point3> points, VoidWalls walls, unsigned threads,
            const std::function<bool(const Progress&)>& progress);

  /// Of voids at this radius, whose triangles are those of `boundary`. Requires: voids of these points, with these walls.
  std::vector<VoidLife> of(double alpha, const Surface& boundary, std::span<const SolidVoid> voids) const;
  /// The largest first.
  std::vector<Pocket> pockets(double alpha) const;

 private:
  VoidLife life(std::uint32_t node) const;

  SolidFiltration filtration_;
  VoidTree tree_;
};

}  // namespace rbpa::app

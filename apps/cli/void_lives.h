// What: at which radii voids of a solid close and are filled; and pockets, which close only above its radius.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/solid.h"
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
  double volume = 0;    ///< when it closes
  Triangle mouth = {};  ///< points of the triangle that closes it
};

class VoidLives {
 public:
  /// Keeps references to the triangulation of all points, and its radii. Throws Cancelled after a signal.
  VoidLives(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii, VoidWalls walls,
            unsigned threads);

  /// Of voids at this radius, with these walls, whose triangles are those of `boundary`.
  std::vector<VoidLife> of(double alpha, const Surface& boundary, std::span<const SolidVoid> voids) const;
  /// The largest first.
  std::vector<Pocket> pockets(double alpha) const;

 private:
  VoidLife life(std::uint32_t node) const;

  const Solid& delaunay_;
  std::span<const double> radii_;
  VoidTree tree_;
};

}  // namespace rbpa::app

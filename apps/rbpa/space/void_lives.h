// What: finds the radii at which voids close and are filled, and the pockets of a solid, which become voids only at
//       larger radii.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/point3.h"
#include "rbpa/base/triangle.h"
#include "rbpa/space/persistence/void_tree.h"
#include "rbpa/space/solid/solid.h"
#include "rbpa/space/solid/voids.h"
#include "rbpa/space/surface/surface.h"

namespace rbpa::app {

struct VoidLife {
  double closes = 0, filled = 0;  ///< the void exists for closes ≤ alpha < filled
  std::size_t depth = 0;          ///< number of times that a larger void splits before this void exists
};

struct Pocket {
  VoidLife life = {};
  double volume = 0;    ///< volume of the void at the radius at which it closes
  Triangle mouth = {};  ///< numbers of the corners of the triangle that closes the pocket
};

class VoidLives {
 public:
  /// Keeps references to `delaunay`, the triangulation of all points, and to `radii`, the circumradii of its
  /// tetrahedra. Throws Cancelled after a signal.
  VoidLives(std::span<const Point3> points, const Solid& delaunay, std::span<const double> radii, ComplexKind walls,
            unsigned threads);

  /// Returns the life of each of `voids`, in their order. Requires: `boundary` and `voids` belong to the solid at
  /// radius `alpha`, with the `walls` of the constructor.
  std::vector<VoidLife> of(double alpha, const Surface& boundary, std::span<const SolidVoid> voids) const;
  /// Returns the pockets of the solid at radius `alpha`, in descending order of volume.
  std::vector<Pocket> pockets(double alpha) const;

 private:
  VoidLife life(std::uint32_t node) const;

  const Solid& delaunay_;
  std::span<const double> radii_;
  VoidTree tree_;
};

}  // namespace rbpa::app

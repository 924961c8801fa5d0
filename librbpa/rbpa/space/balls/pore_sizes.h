// What:   computes the sizes of the pores between balls in a cell that repeats: the largest ball that fits in, and the
//         largest that passes through the cell along each edge.
// How:    balls are grown until no path leads from a tetrahedron outside of them to its image. The neck of the widest
//         path gives the next growth: the radius of the ball that touches the balls there. docs/explanation/space.md,
//         section 28.
// Law:    a growth is decided by exact predicates; radii are rounded, with an error of about 10⁻¹².
// Cost:   that of periodic_ball_voids(), and some ten triangulations.
// Source: Willems, Rycroft, Kazi, Meza, Haranczyk, Algorithms and tools for high-throughput geometry-based analysis of
//         crystalline porous materials (2012).
#pragma once

#include <array>
#include <span>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/space/balls/periodic_balls.h"

namespace rbpa {

/// Radii of balls that meet no other ball, in the unit of the coordinates. Zeo++ states diameters: D_i = 2 `included`,
/// D_f = 2 `passing`, D_if = 2 `on_the_way`.
struct PoreSizes {
  double included = 0;    ///< of the largest ball that fits in; 0 if none does
  double passing = 0;     ///< of the largest ball that can move to an image of itself: the greatest of `along`
  double on_the_way = 0;  ///< of the largest ball that fits in where the passing one can move; 0 if none passes
  /// For each edge of the cell, of the largest ball that can move to an image that is away along this edge, whatever it
  /// moves along the others; 0 if none can.
  std::array<double, 3> along = {0, 0, 0};
};

/// Computes the sizes. Options are those of periodic_ball_voids().
/// Requires, throws: as periodic_ball_voids(); at least one ball.
RBPA_API PoreSizes pore_sizes(std::span<const Point3> centers, std::span<const double> radii, const RepeatingCell& cell,
                              const SolidOptions& options = {});

}  // namespace rbpa

// What:   moves noisy points in space onto the surface about which they scatter, so that a ball can roll over them.
// How:    each step projects all points together, each onto the plane that best fits the point and its nearest others.
// Law:    a function of the set of points, not of any order or thread; multiplying all points by a power of two
//         multiplies the result. Equal points stay equal. The result is an estimate, in rounded numbers.
// Cost:   for each step, that of estimate_normals() without turning normals.
// Source: Digne, Morel, Souzani, Lartigue, Scale space meshing of raw data point sets (2011): the surface is made of
//         the moved points; its triangles then connect the original points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa {

struct ScaleSpaceOptions {
  /// Number of steps. If 0, at most 8 steps: the last one is the first that moves the median point, relative to its
  /// neighbors, by less than a tenth of the distance between neighbors. Each step shrinks a curved surface a little.
  std::size_t steps = 0;
  /// Number of nearest other points to which the plane is fitted, together with the point itself; all others if there
  /// are fewer. More points smooth more.
  std::size_t neighbors = 30;
  MaxThreads threads = 0;
  OnProgress progress = {};  ///< Progress::triangles is 0
};

struct ScaleSpace {
  std::vector<Point3> points;  ///< the moved points, in the order of the input
  std::size_t steps = 0;       ///< number of steps that were made; 0 if there is no point
};

/// Returns the moved points, and the number of steps.
/// Requires: finite points, fewer than 2^32 − 1; at least 2 neighbors.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API ScaleSpace scale_space(std::span<const Point3> points, const ScaleSpaceOptions& options = {});

}  // namespace rbpa

// What:   moves noisy points in space onto the surface about which they scatter, so that a ball can roll over them.
// How:    each step projects every point onto the plane that fits it and its nearest others best, all points at once.
// Law:    a function of the set of points, not of any order or thread; multiplying all points by a power of two
//         multiplies the result. Equal points stay equal. The result is an estimate, in rounded numbers.
// Cost:   for each step, that of estimate_normals() without turning the normals.
// Source: Digne, Morel, Souzani, Lartigue, Scale space meshing of raw data point sets (2011): the surface is made of
//         the moved points, and its triangles are then taken for the original points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa {

struct ScaleSpaceOptions {
  /// Number of steps. 0: until a step moves the median point, relative to its neighbors, by less than a tenth of the
  /// distance between neighbors, at least 1 and at most 8. A curved surface shrinks a little in each step.
  std::size_t steps = 0;
  /// Number of nearest other points to which, with the point itself, the plane is fitted; all if there are fewer. More
  /// points smooth more.
  std::size_t neighbors = 30;
  MaxThreads threads = 0;
  OnProgress progress = {};  ///< Progress::triangles is 0
};

struct ScaleSpace {
  std::vector<Point3> points;  ///< the moved points, in the order of the input
  std::size_t steps = 0;       ///< number of steps that were made; 0 if there is no point
};

/// Returns the points, moved by the steps.
/// Requires: finite points, fewer than 2^32 − 1; at least 2 neighbors.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API ScaleSpace scale_space(std::span<const Point3> points, const ScaleSpaceOptions& options = {});

}  // namespace rbpa

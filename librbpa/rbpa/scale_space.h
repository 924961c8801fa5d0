// What:   points of space moved onto the surface that they are scattered about, so that a ball rolls over them.
// How:    in each step every point is moved to the plane that fits it and its nearest others best, all at once.
// Law:    a function of the set of points, of no order and no thread; multiplying all by a power of two multiplies the result.
//         Equal points stay equal. An estimate, in rounded numbers.
// Cost:   for each step that of estimate_normals() without turning them.
// Source: Digne, Morel, Souzani, Lartigue, Scale space meshing of raw data point sets (2011): the surface is made of the moved
//         points, and its triangles are those of the points as they came.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa {

struct ScaleSpaceOptions {
  /// 0: until a step moves the median point otherwise than its neighbors by less than a tenth of the distance between them, at
  /// most 8. A curved surface moves as well, but together: it shrinks a little in each step.
  std::size_t steps = 0;
  /// The plane is fitted to a point and this many nearest others. More smooth more in each step.
  std::size_t neighbors = 30;
  /// Threads that work at most, the calling one included. 0 = all processors; larger values are capped.
  unsigned threads = 0;
  /// Called repeatedly, with no triangles, one call at a time but from any thread of the run. Returning false cancels the run.
  /// Empty: never called.
  std::function<bool(const Progress&)> progress = {};
};

struct ScaleSpace {
  std::vector<Point3> points;  ///< moved, in the order in which they came
  std::size_t steps = 0;       ///< that were made
};

/// Requires: finite points, fewer than 2^32 − 1; at least 2 neighbors. Throws: InvalidInput that names the violated requirement;
/// Cancelled.
RBPA_API ScaleSpace scale_space(std::span<const Point3> points, const ScaleSpaceOptions& options = {});

}  // namespace rbpa

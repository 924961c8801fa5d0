// What:   points of space that stand alone: much farther from their nearest others than most points are.
// Law:    a function of the set of points, of no order and no thread; equal points are outliers together, and count as one. Multiplying all by
//         a power of two changes nothing but the distance.
// Note:   one distance for the whole set: of a scan whose parts differ in density by more than the factor, the sparse parts are left out
//         as well.
// Cost:   that of nearest points, about a third of estimate_normals().
// Source: Rusu, Marton, Blodow, Dolha, Beetz, Towards 3D point cloud based object maps (2008), with the median in place of mean and deviation,
//         which outliers move.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa {

struct OutlierOptions {
  /// An outlier is more than so many times as far from its last neighbor as the median point is.
  double factor = 4;
  /// The distance is that to this nearest other point: fewer than so many outliers that lie close together are found.
  std::size_t neighbors = 8;
  /// Threads that work at most, the calling one included. 0 = all processors; larger values are capped.
  unsigned threads = 0;
  /// Called repeatedly, with no triangles, one call at a time but from any thread of the run. Returning false cancels the run.
  /// Empty: never called.
  std::function<bool(const Progress&)> progress = {};
};

struct Outliers {
  std::vector<std::uint32_t> points;  ///< input indices, ascending
  double distance =
      0;  ///< that of the median point, rounded; 0 of fewer than two distinct points, which are no outliers
};

/// Requires: finite points, fewer than 2^32 − 1; factor ≥ 1, neighbors ≥ 1. Throws: InvalidInput that names the violated requirement;
/// Cancelled.
RBPA_API Outliers outliers(std::span<const Point3> points, const OutlierOptions& options = {});

}  // namespace rbpa

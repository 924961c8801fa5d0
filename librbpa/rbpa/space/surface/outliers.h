// What:   finds outliers in space: points that are much farther from their nearest neighbors than most points are.
// Law:    a function of the set of points, not of any order or thread; distances are rounded. Equal points count as
//         one, and are outliers together. Multiplying all points by a power of two changes no outlier, and multiplies
//         the median distance.
// Cost:   O(n log n), about a third of the cost of estimate_normals(). Memory: 4 · `neighbors` bytes a point, and a few
//         copies of the points.
// Source: Rusu, Marton, Blodow, Dolha, Beetz, Towards 3D point cloud based object maps (2008). The median takes the
//         place of mean and deviation, which outliers move.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/api.h"
#include "rbpa/base/point3.h"
#include "rbpa/base/progress.h"

namespace rbpa {

struct OutlierOptions {
  /// A point is an outlier if its distance to the neighbor of rank `neighbors` is more than `factor` times the median
  /// of these distances at distinct points (the upper median of an even number). Sparse parts of a scan that have fewer
  /// than half of the points are outliers too if their spacing is more than `factor` times that of the rest.
  double factor = 4;
  /// Rank of the neighbor to which the distance is measured; 1 is the nearest other point. If there are fewer other
  /// points, the distance to the farthest counts. Groups of up to `neighbors` outliers close together are found.
  std::size_t neighbors = 8;
  MaxThreads threads = 0;
  OnProgress progress = {};  ///< Progress::triangles is 0
};

struct Outliers {
  std::vector<std::uint32_t> points;  ///< input indices, ascending
  /// The median distance, rounded, in units of the points. Infinity if it exceeds the largest double; 0, without
  /// outliers, for fewer than two distinct points.
  double distance = 0;
};

/// Finds the outliers, as OutlierOptions::factor defines them, and the median distance.
/// Requires: finite points, fewer than 2^32 − 1; factor ≥ 1, neighbors ≥ 1.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API Outliers outliers(std::span<const Point3> points, const OutlierOptions& options = {});

}  // namespace rbpa

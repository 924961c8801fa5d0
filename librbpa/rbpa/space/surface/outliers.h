// What:   finds outliers in space: points that are much farther from their nearest neighbors than most points are.
// Law:    a function of the set of points, not of any order or thread. Equal points count as one, and are outliers
//         together. Multiplying all points by a power of two changes nothing but the distance.
// Note:   one distance applies to the whole set: if parts of a scan differ in density by more than the factor, the
//         sparse parts are outliers as well.
// Cost:   that of a search for nearest points, about a third of estimate_normals().
// Source: Rusu, Marton, Blodow, Dolha, Beetz, Towards 3D point cloud based object maps (2008), with the median in place
//         of mean and deviation, which outliers move.
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
  /// The bound: an outlier is more than `factor` times as far from its last neighbor as the median point is.
  double factor = 4;
  /// Rank of the nearest other point to which the distance is measured. Groups of fewer than this many outliers that
  /// lie close together are found.
  std::size_t neighbors = 8;
  MaxThreads threads = 0;
  OnProgress progress = {};  ///< with 0 triangles
};

struct Outliers {
  std::vector<std::uint32_t> points;  ///< input indices, ascending
  /// The distance of the median point, rounded; 0 for fewer than two distinct points, which are not outliers.
  double distance = 0;
};

/// Finds the outliers.
/// Requires: finite points, fewer than 2^32 − 1; factor ≥ 1, neighbors ≥ 1.
/// Throws:   InvalidInput that names the violated requirement; Cancelled.
RBPA_API Outliers outliers(std::span<const Point3> points, const OutlierOptions& options = {});

}  // namespace rbpa

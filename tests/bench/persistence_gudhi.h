// What: runs GUDHI's persistence of the alpha complex in space as a user does: AlphaComplex with precision "fast",
//       cohomology with coefficients in Z/2.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "rbpa/base/point3.h"

namespace rbpa_bench {

struct PersistenceRun {
  std::array<std::size_t, 3> pairs;  ///< for each dimension, the number of pairs that last longer than rounding
  double complex_seconds;            ///< processor time until the simplices have radii
  double pairs_seconds;
};

/// Computes pairs from points.
PersistenceRun persistence_by_gudhi(std::span<const rbpa::Point3> points);

}  // namespace rbpa_bench

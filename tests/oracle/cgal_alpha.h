// What: the alphas that CGAL's Alpha_shape_2 proposes, with exact constructions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa_test {

struct ProposedAlphas {
  double covering;  ///< find_alpha_solid(): a radius, not its square
  /// find_optimal_alpha(K) for each given K, as radii. CGAL returns the value after the one that it found, except at
  /// the end; this is the one that it found.
  std::vector<double> optimal;
};

/// Returns the proposals of CGAL. Requires: three points that are not on a line; squares of radii are in the range of
/// double.
ProposedAlphas cgal_alphas(std::span<const rbpa::Point> points, std::span<const std::size_t> max_components);

}  // namespace rbpa_test

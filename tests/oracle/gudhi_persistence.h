// What: the persistence of the alpha complex, by GUDHI.
// How:  its Alpha_complex on CGAL's exact kernel, exact squared radii rounded to double; cohomology with coefficients
//       in Z/2.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "rbpa/base/point.h"
#include "rbpa/base/point3.h"

namespace rbpa_test {

struct SquaredPair {
  int dimension;
  double birth;  ///< squared radius, or power
  double death = std::numeric_limits<double>::infinity();
};

/// Returns all pairs with birth < death after rounding. Requires: squares of radii are in the range of double.
std::vector<SquaredPair> gudhi_persistence(std::span<const rbpa::Point> points);
std::vector<SquaredPair> gudhi_persistence(std::span<const rbpa::Point3> points);
/// Returns those of the weighted alpha complex. Requires: one weight, a squared radius, for each point.
std::vector<SquaredPair> gudhi_persistence(std::span<const rbpa::Point3> points, std::span<const double> weights);

}  // namespace rbpa_test

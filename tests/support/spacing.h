// What: the mean spacing of a point set, the unit in which tests choose alpha.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa_test {

/// Returns √(area of the box / number of distinct points); for a box without area, its longer side divided by that
/// number.
/// Always positive and finite: 1 when all points are equal.
double mean_spacing(std::span<const rbpa::Point> points);

/// Returns the radii with which every set is tested: tiny, 0.5, 1, 2 and 10 mean spacings, infinity.
std::vector<double> usual_alphas(std::span<const rbpa::Point> points);

}  // namespace rbpa_test

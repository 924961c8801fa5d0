// What: how far the points of a set are apart on average, the unit in which tests choose alpha.
#pragma once

#include <span>
#include <vector>

#include "rbpa/base/point.h"

namespace rbpa_test {

/// √(area of the box / number of distinct points); for a box without area its longer side divided by that number.
/// Always positive and finite: 1 when all points are equal.
double mean_spacing(std::span<const rbpa::Point> points);

/// The radii that every set is tested with: tiny, 0.5, 1, 2 and 10 mean spacings, infinity.
std::vector<double> usual_alphas(std::span<const rbpa::Point> points);

}  // namespace rbpa_test

// What: sets of points that are small enough to be built anew at every one of their radii.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/triangle.h"

namespace rbpa_test {

/// Scattered, gridded, cocircular, collinear, repeated, clustered, sparse, extreme; named.
const std::vector<std::pair<std::string, Points>>& small_sets();

}  // namespace rbpa_test

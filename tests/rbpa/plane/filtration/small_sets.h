// What: sets of points that are small enough to be built anew at every one of their radii.
#pragma once

#include <string>
#include <vector>

#include "support/triangle.h"

namespace rbpa_test {

struct SmallSet {
  std::string name;
  Points points;
};

/// Scattered, gridded, cocircular, collinear, repeated, clustered, sparse, extreme.
const std::vector<SmallSet>& small_sets();

}  // namespace rbpa_test

// What: sets of points small enough to build the complex anew at every radius.
#pragma once

#include <string>
#include <vector>

#include "support/triangle.h"

namespace rbpa_test {

struct SmallSet {
  std::string name;
  Points points;
};

/// Returns scattered, gridded, cocircular, collinear, duplicate, clustered, sparse and extreme points.
const std::vector<SmallSet>& small_sets();

}  // namespace rbpa_test

// What: sets of points small enough to build the complex anew at every radius.
#pragma once

#include <doctest/doctest.h>

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

/// Calls `check(points)` for each of them.
template <typename Check>
void on_small_sets(const Check& check) {
  for (const SmallSet& set : small_sets()) {
    CAPTURE(set.name);
    check(set.points);
  }
}

}  // namespace rbpa_test

// What: the table of generated point sets that a test can run over.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "support/triangle.h"

namespace rbpa_test {

struct NamedSet {
  std::string_view name;
  Points (*make)();
  std::vector<double> alphas = {};  ///< radii at which something of this set is decided by a tie, or just not
};

/// Every generated set, some thousands of points at most.
std::span<const NamedSet> generated_sets();

}  // namespace rbpa_test

// What: the table of generated point sets over which tests run.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "support/triangle.h"

namespace rbpa_test {

struct NamedSet {
  std::string_view name;
  Points (*make)();
  std::vector<double> alphas = {};  ///< radii at which a decision in this set is a tie, or nearly one
};

/// Returns every generated set; each has some thousands of points at most.
std::span<const NamedSet> generated_sets();

}  // namespace rbpa_test

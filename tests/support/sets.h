// What: the table of generated point sets over which tests run.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "support/triangle.h"

namespace rbpa_test {

struct NamedSet {
  std::string_view name;
  Points (*make)();
  std::vector<double> alphas = {};  ///< radii at which a decision in this set is a tie, or nearly one

  /// Return the points, at most so many: those at the beginning, or a random subset.
  Points first(std::size_t most) const;
  Points some(std::size_t most) const;
};

/// Returns every generated set; each has some thousands of points at most.
std::span<const NamedSet> generated_sets();

}  // namespace rbpa_test

// What: decides which of several heights at one place of the plane counts: the lowest, for any order of the points.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rbpa/base/duplicate.h"

namespace rbpa::app {

/// Sets the value of the point that stands for all at its place to the lowest of their values, column by column.
/// `values` has a row of `columns` numbers for each point, of which NaN does not count. Returns the number of places
/// with several values.
inline std::size_t take_lowest(std::span<const Duplicate> duplicates, std::span<double> values,
                               std::size_t columns = 1) {
  std::vector<std::uint32_t> several;
  for (const auto& [index, first] : duplicates)
    for (std::size_t k = 0; k < columns; ++k) {
      double& lowest = values[first * columns + k];
      const double other = values[index * columns + k];
      if (other < lowest || other > lowest) several.push_back(first);
      if (std::isnan(lowest) || other < lowest) lowest = other;
    }
  std::sort(several.begin(), several.end());
  return static_cast<std::size_t>(std::unique(several.begin(), several.end()) - several.begin());
}

}  // namespace rbpa::app

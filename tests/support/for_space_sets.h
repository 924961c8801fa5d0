// What: runs a check on sets of points in space of every kind.
#pragma once

#include <doctest/doctest.h>

#include <type_traits>

#include "support/space_sets.h"

namespace rbpa_test {

/// Calls `check(points)`, or `check(points, kind, trial)`, for so many sets of each kind, each drawn for `least` points
/// and up to `more` others.
template <typename Check>
void for_space_sets(int trials, std::size_t least, std::size_t more, Random& random, const Check& check) {
  for (int k = 0; k < space_kinds; ++k)
    for (int trial = 0; trial < trials; ++trial) {
      const auto kind = static_cast<SpaceKind>(k);
      CAPTURE(name(kind));
      CAPTURE(trial);
      const Points3 points = space_set(kind, more == 0 ? least : least + random.below(more + 1), random);
      if constexpr (std::is_invocable_v<Check, Points3>)
        check(points);
      else
        check(points, kind, trial);
    }
}

}  // namespace rbpa_test

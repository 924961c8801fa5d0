// What: runs a check on sets of points in space that have tetrahedra.
#pragma once

#include <doctest/doctest.h>

#include <cstddef>
#include <limits>

#include "rbpa/space/solid/solid.h"
#include "support/solid_sets.h"

namespace rbpa_test {

/// Calls `check(points)` for the solid ones of solid_sets().
template <typename Check>
void for_solids(std::size_t count, const Check& check) {
  for (const SolidSet& set : solid_sets(count)) {
    CAPTURE(set.name);
    if (set.is_solid) check(set.points);
  }
}

/// Calls it for those with at most so many tetrahedra.
template <typename Check>
void for_solids(std::size_t count, std::size_t most, const Check& check) {
  for_solids(count, [&](const Points3& points) {
    const auto tetrahedra = rbpa::solid(points, std::numeric_limits<double>::infinity()).simplices.size();
    if (0 < tetrahedra && tetrahedra <= most) check(points);
  });
}

}  // namespace rbpa_test

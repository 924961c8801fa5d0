// What: pairs of generated sets, one of which is scaled to extreme exponents. Both must give the same result, though
//       one is computed by tiles and remainder in double, the other by pivots and seeds in long double.
#pragma once

#include <doctest/doctest.h>

#include "rbpa/base/exact/magnitude.h"
#include "support/generate.h"
#include "support/sets.h"

namespace rbpa_test {

inline constexpr int far_exponent = 850;  ///< the far points are the near ones times 2 to this power

/// Calls visit(std::string_view name, near, far) for every generated set of moderate size that can be scaled that far.
template <typename Visit>
void for_each_far_set(Visit visit) {
  int sets = 0;
  for (const NamedSet& set : generated_sets()) {
    const Points near = set.make();
    if (near.size() > 1100 || !rbpa::fits_double(rbpa::magnitude(near))) continue;
    const Points far = scaled(near, far_exponent);
    if (rbpa::fits_double(rbpa::magnitude(far))) continue;
    ++sets;
    visit(set.name, near, far);
  }
  CHECK(sets > 15);
}

}  // namespace rbpa_test

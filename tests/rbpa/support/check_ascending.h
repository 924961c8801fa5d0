// What: the law of the calls of a progress callback in the plane.
#pragma once

#include <doctest/doctest.h>

#include <cstddef>
#include <vector>

#include "rbpa/base/progress.h"

namespace rbpa_test {

/// Checks that there are several calls, with the number of points, and ascending numbers of at most `triangles`.
inline void check_ascending(const std::vector<rbpa::Progress>& seen, std::size_t points, std::size_t triangles) {
  REQUIRE(seen.size() >= 2);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    CHECK(seen[i].points == points);
    CHECK(seen[i].triangles <= triangles);
    if (i > 0) CHECK(seen[i].triangles >= seen[i - 1].triangles);
  }
}

}  // namespace rbpa_test

// What: std::sort() that Ctrl-C can interrupt.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "io/interrupt.h"

namespace rbpa::app {

/// Sorts `values`. Throws Cancelled after a signal; then the values are in any order.
template <typename Values, typename Less = std::less<>>
void sort(Values& values, Less less = {}) {
  std::size_t compared = 0;
  std::sort(values.begin(), values.end(), [&](const auto& a, const auto& b) {
    if (++compared % 65536 == 0) stop_if_interrupted();
    return less(a, b);
  });
}

}  // namespace rbpa::app

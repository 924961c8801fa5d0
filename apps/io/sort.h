// What: std::sort() that Ctrl-C can interrupt.
#pragma once

#include <algorithm>
#include <functional>

#include "io/interrupt.h"

namespace rbpa::app {

/// Sorts `values`. Throws Cancelled after a signal; then the values are in any order.
template <typename Values, typename Less = std::less<>>
void sort(Values& values, Less less = {}) {
  InterruptibleSteps step;
  std::sort(values.begin(), values.end(), [&](const auto& a, const auto& b) {
    step();
    return less(a, b);
  });
}

}  // namespace rbpa::app

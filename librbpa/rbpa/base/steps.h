// What: cancellation of loops and sorts.
#pragma once

#include <algorithm>

#include "meshops/core/progress.h"

namespace rbpa {

using meshops::Steps;

/// std::sort(), each comparison a step. Throws Cancelled, with the values in any order.
template <typename Values, typename Less>
void sort(Values& values, Steps& step, const Less& less) {
  std::sort(values.begin(), values.end(), [&](const auto& a, const auto& b) {
    step();
    return less(a, b);
  });
}

}  // namespace rbpa

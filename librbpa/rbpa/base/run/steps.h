// What: cancellation within loops and sorts.
#pragma once

#include <algorithm>

#include "rbpa/base/progress.h"

namespace rbpa {

using meshops::Steps;

/// Sorts values like std::sort(), and counts each comparison as a step.
/// Throws: Cancelled; the values are then in any order, and some may be lost.
template <typename Values, typename Less>
void sort(Values& values, Steps& step, const Less& less) {
  std::sort(values.begin(), values.end(), [&](const auto& a, const auto& b) {
    step();
    return less(a, b);
  });
}

}  // namespace rbpa

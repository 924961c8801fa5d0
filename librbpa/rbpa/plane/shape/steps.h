// What: how loops and sorts over a boundary let their caller end them.
#pragma once

#include <algorithm>

#include "meshops/topology/progress.h"
#include "rbpa/base/error.h"

namespace rbpa {

using Steps = meshops::detail::StepsUntil<Cancelled>;

/// std::sort(), each comparison a step. Throws Cancelled, with the values in any order.
template <typename Values, typename Less>
void sort(Values& values, Steps& step, const Less& less) {
  std::sort(values.begin(), values.end(), [&](const auto& a, const auto& b) {
    step();
    return less(a, b);
  });
}

}  // namespace rbpa

// What: sorts a list of values and removes repeated values.
#pragma once

#include <algorithm>

namespace rbpa {

template <typename Values>
void sort_unique(Values& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace rbpa

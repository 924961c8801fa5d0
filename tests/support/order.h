// What: puts values into a random order, or into theirs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "support/random.h"

namespace rbpa_test {

/// Returns the numbers below `count` in a random order.
inline std::vector<std::uint32_t> random_order(std::size_t count, Random& random) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  random.shuffle(order);
  return order;
}

/// Returns the values with these numbers, in their order.
template <typename Value>
std::vector<Value> in_order(const std::vector<Value>& values, const std::vector<std::uint32_t>& order) {
  std::vector<Value> result;
  for (const std::uint32_t i : order) result.push_back(values[i]);
  return result;
}

/// Sorts the values, and removes all but one of equal ones.
template <typename Value>
void sort_distinct(std::vector<Value>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace rbpa_test

// What: the values of some items, out of those of all.
#pragma once

#include <cstdint>
#include <ranges>
#include <span>
#include <vector>

namespace rbpa::app {

/// None where there are no values: nothing is known of any item then.
template <std::ranges::random_access_range Values>
std::vector<std::ranges::range_value_t<Values>> values_at(const Values& values, std::span<const std::uint32_t> items) {
  std::vector<std::ranges::range_value_t<Values>> result;
  if (std::ranges::empty(values)) return result;
  result.reserve(items.size());
  for (const std::uint32_t i : items) result.push_back(values[i]);
  return result;
}

}  // namespace rbpa::app
